#include "ui/widgets/gui.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "ui/widgets/typed_number.h"

namespace erg::ui {
namespace {

// Latin, Greek, Cyrillic, dashes and quotes, sub- and superscripts, arrows, mathematics, geometric shapes. What is in
// none of these is loaded when it is needed.
constexpr std::array<ImWchar, 23> letters{0x20,   0x24f,  0x370,  0x3ff,  0x400,  0x52f,  0x2010, 0x2027,
                                          0x2030, 0x203a, 0x2070, 0x209c, 0x2190, 0x21ff, 0x2200, 0x22ff,
                                          0x2300, 0x23ff, 0x25a0, 0x26ff, 0x2700, 0x27bf, 0};

void map_keys(ImGuiIO& io) {
  const std::array<std::pair<ImGuiKey, int>, 22> map{{
      {ImGuiKey_Tab, keys::tab},
      {ImGuiKey_LeftArrow, keys::left},
      {ImGuiKey_RightArrow, keys::right},
      {ImGuiKey_UpArrow, keys::up},
      {ImGuiKey_DownArrow, keys::down},
      {ImGuiKey_PageUp, keys::page_up},
      {ImGuiKey_PageDown, keys::page_down},
      {ImGuiKey_Home, keys::home},
      {ImGuiKey_End, keys::end},
      {ImGuiKey_Insert, keys::insert},
      {ImGuiKey_Delete, keys::remove},
      {ImGuiKey_Backspace, keys::backspace},
      {ImGuiKey_Space, keys::space},
      {ImGuiKey_Enter, keys::enter},
      {ImGuiKey_Escape, keys::escape},
      {ImGuiKey_KeyPadEnter, keys::enter},
      {ImGuiKey_A, 'A'},
      {ImGuiKey_C, 'C'},
      {ImGuiKey_V, 'V'},
      {ImGuiKey_X, 'X'},
      {ImGuiKey_Y, 'Y'},
      {ImGuiKey_Z, 'Z'},
  }};
  for (const auto& [key, place] : map) io.KeyMap[key] = place;
}

/// Whether what is being typed into takes a number.
bool types_a_number() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  constexpr ImGuiInputTextFlags number = ImGuiInputTextFlags_CharsDecimal | ImGuiInputTextFlags_CharsScientific;
  return context.ActiveId != 0 && context.InputTextState.ID == context.ActiveId &&
         (context.InputTextState.Flags & number) != 0;
}

const char* (*clipboard_text)(void*) = nullptr;  // the function that was there before ours

const char* pasted_text(void* user_data) {
  static std::string text;  // ImGui reads it at once
  const char* const copied = clipboard_text(user_data);
  if (copied == nullptr || !types_a_number()) return copied;
  text = as_pasted_number(copied);
  return text.c_str();
}

/// The same for what is pasted, whoever owns the clipboard.
void watch_pasting() {
  ImGuiIO& io = ImGui::GetIO();
  if (io.GetClipboardTextFn == pasted_text || io.GetClipboardTextFn == nullptr) return;
  clipboard_text = io.GetClipboardTextFn;
  io.GetClipboardTextFn = pasted_text;
}

ImFont* add_font(ImFontAtlas& atlas, const FontFile& file, const ImFontConfig& settings, const ImWchar* ranges) {
  ImFontConfig config = settings;
  config.FontNo = file.face;
  return atlas.AddFontFromFileTTF(file.path.c_str(), config.SizePixels, &config, ranges);
}

}  // namespace

Gui::Gui(ThemeKind theme, float scale) : context_(ImGui::CreateContext()), theme_(Theme::make(theme)), scale_(scale) {
  ImGui::SetCurrentContext(context_);
  ImGuiIO& io = ImGui::GetIO();
  io.UserData = this;
  io.IniFilename = nullptr;  // the layout is kept with the other settings
  io.LogFilename = nullptr;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  map_keys(io);
  apply_theme(theme_, scale_);
  load_fonts();
}

Gui::~Gui() { ImGui::DestroyContext(context_); }

Gui& Gui::current() { return *static_cast<Gui*>(ImGui::GetIO().UserData); }

void Gui::set_theme(ThemeKind theme) {
  theme_ = Theme::make(theme);
  apply_theme(theme_, scale_);
}

void Gui::set_scale(float scale) {
  if (scale == scale_) return;
  scale_ = scale;
  apply_theme(theme_, scale_);
  load_fonts();
}

void Gui::load_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  font_ranges_.clear();
  const std::optional<FontFile> file = fonts_.interface_font();
  for (const float size : {text_size, heading_size}) {
    ImFontConfig config;
    config.SizePixels = std::round(px(file ? size : 13));
    heading_font_ = file ? add_font(atlas, *file, config, letters.data()) : atlas.AddFontDefault(&config);
    load_more_letters(config);
  }
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);  // without this ImGui refuses to begin a frame
  atlas.ClearInputData();                              // fonts with the letters of East Asia are large
  fonts_stale_ = false;
  ++font_version_;
  note_missing_letters();
}

/// Into the font added last, from all fonts that have them.
void Gui::load_more_letters(const ImFontConfig& like) {
  std::map<std::string, std::pair<FontFile, ImFontGlyphRangesBuilder>> wanted;
  for (const char32_t letter : more_letters_) {
    const std::optional<FontFile> file = no_font_has_.contains(letter) ? std::nullopt : fonts_.font_with(letter);
    if (!file) continue;
    auto& [font, ranges] = wanted[file->path + std::to_string(file->face)];
    font = *file;
    ranges.AddChar(static_cast<ImWchar>(letter));
  }
  for (auto& [name, of_font] : wanted) {
    ImVector<ImWchar>& ranges = font_ranges_.emplace_back();  // the atlas reads them when it is built
    of_font.second.BuildRanges(&ranges);
    ImFontConfig config = like;
    config.MergeMode = true;
    add_font(*ImGui::GetIO().Fonts, of_font.first, config, ranges.Data);
  }
}

void Gui::note_missing_letters() {
  for (const char32_t letter : more_letters_) {
    if (heading_font_->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr) continue;
    if (!no_font_has_.insert(letter).second) continue;
    std::array<char, 16> number{};
    std::snprintf(number.data(), number.size(), "U+%04X", static_cast<unsigned>(letter));
    missing_ += (missing_.empty() ? "" : ", ") + ("\"" + utf8_of(letter) + "\" (") + number.data() + ")";
  }
}

void Gui::need(std::string_view text) {
  constexpr char32_t first_unusual = 0x250;
  constexpr char32_t last_of_plane = 0xffff;  // ImGui has no more
  while (!text.empty()) {
    const char32_t letter = take_letter(text);
    if (letter < first_unusual || letter > last_of_plane || letter == 0xfffd) continue;
    if (heading_font_->FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr) continue;
    fonts_stale_ = more_letters_.insert(letter).second || fonts_stale_;
  }
}

std::string Gui::take_missing_letters() { return std::exchange(missing_, {}); }

void Gui::frame(ImVec2 size, float seconds, const std::function<void()>& draw) {
  if (fonts_stale_) load_fonts();
  watch_pasting();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = size;
  io.DeltaTime = std::max(seconds, 1e-4f);
  widgets_.begin_frame();
  ImGui::NewFrame();
  for (const ImWchar letter : io.InputQueueCharacters) need(utf8_of(letter));
  draw();
  ImGui::Render();
}

}  // namespace erg::ui
