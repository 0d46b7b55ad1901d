#include "ui/gui.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace erg {
namespace {

// Latin, Greek, dashes and quotes, sub- and superscripts, arrows, mathematics, geometric shapes.
constexpr std::array<ImWchar, 21> letters{0x20,   0x17f,  0x370,  0x3ff,  0x2010, 0x2027, 0x2030,
                                          0x203a, 0x2070, 0x209c, 0x2190, 0x21ff, 0x2200, 0x22ff,
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
  const std::string file = interface_font();
  if (file.empty()) {
    ImFontConfig plain;
    plain.SizePixels = std::round(px(13));
    heading_font_ = atlas.AddFontDefault(&plain);
  } else {
    atlas.AddFontFromFileTTF(file.c_str(), std::round(px(text_size)), nullptr, letters.data());
    heading_font_ = atlas.AddFontFromFileTTF(file.c_str(), std::round(px(heading_size)), nullptr, letters.data());
  }
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  atlas.GetTexDataAsRGBA32(&pixels, &width, &height);  // without this ImGui refuses to begin a frame
  ++font_version_;
}

void Gui::frame(ImVec2 size, float seconds, const std::function<void()>& draw) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = size;
  io.DeltaTime = std::max(seconds, 1e-4f);
  widgets_.begin_frame();
  ImGui::NewFrame();
  draw();
  ImGui::Render();
}

}  // namespace erg
