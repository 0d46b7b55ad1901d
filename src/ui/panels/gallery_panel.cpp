// GALLERY: the presets with their pictures. One click and dunes grow.
#include <imgui_internal.h>

#include <algorithm>

#include "core/errors.h"
#include "io/config/config_file.h"
#include "io/config/preset_list.h"
#include "models/model.h"
#include "session/app_model.h"
#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"

namespace erg::ui {

using io::Preset;
using session::AppModel;

namespace {

// At scale 1, pixels.
constexpr float card_width = 224;
constexpr float picture_height = 140;
constexpr float card_gap = 12;

/// What a card says.
struct Card {
  Preset preset;
  std::filesystem::path picture;
  std::string title;
  std::string description;
  std::string model;
  std::string folder;  ///< "" or "thesis"
};

Card card_of(const Preset& preset, const std::filesystem::path& folder) {
  Card card{preset, io::preset_picture(folder, preset.name), preset.name, "", "", ""};
  const std::size_t slash = preset.name.find('/');
  if (slash != std::string::npos) card.folder = preset.name.substr(0, slash);
  try {
    const sim::Config config = io::read_config(preset.path);
    if (!config.title.empty()) card.title = config.title;
    card.description = config.description;
    card.model = models::find_model(config.model).info.title;
  } catch (const InputError& error) {
    card.description = error.what();
  }
  return card;
}

class GalleryPanel final : public Panel {
 public:
  const char* title() const override { return panel_title::gallery; }
  Dock dock() const override { return Dock::dialog; }
  ImVec2 size() const override { return {1000, 640}; }
  void draw(PanelContext& context) override;

 private:
  void read_cards(const AppModel& app);
  void draw_cards(PanelContext& context, const std::string& folder);
  bool draw_card(PanelContext& context, const Card& card) const;

  std::vector<Card> cards_;
  bool read_ = false;
};

void GalleryPanel::read_cards(const AppModel& app) {
  read_ = true;
  const std::filesystem::path& folder = app.folders().presets;
  for (const Preset& preset : io::list_presets(folder)) cards_.push_back(card_of(preset, folder));
}

/// The picture, or where there is none the name of the model in its place.
void draw_picture(PanelContext& context, const Card& card, ImVec2 corner, ImVec2 end) {
  const Theme& theme = Gui::current().theme();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImTextureID texture = context.picture ? context.picture(card.picture) : nullptr;
  if (texture != nullptr) {
    list.AddImageRounded(texture, corner, end, {0, 0}, {1, 1}, IM_COL32_WHITE, Gui::current().px(4),
                         ImDrawFlags_RoundCornersTop);
    return;
  }
  list.AddRectFilled(corner, end, ImGui::GetColorU32(theme.field), Gui::current().px(4), ImDrawFlags_RoundCornersTop);
  const ImVec2 size = ImGui::CalcTextSize(card.model.c_str());
  list.AddText({(corner.x + end.x - size.x) / 2, (corner.y + end.y - size.y) / 2}, ImGui::GetColorU32(theme.faint),
               card.model.c_str());
}

/// Opens a preset and lets it run.
void grow(PanelContext& context, const std::filesystem::path& preset) {
  if (context.app.open_and_play(preset)) {
    context.close(panel_title::gallery);
  } else {
    context.open(panel_title::log);
  }
}

bool GalleryPanel::draw_card(PanelContext& context, const Card& card) const {
  const Gui& gui = Gui::current();
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const ImVec2 size{gui.px(card_width), gui.px(picture_height) + 3 * line + gui.px(14)};
  const ImVec2 end{corner.x + size.x, corner.y + size.y};
  const bool pressed = ImGui::InvisibleButton(card.preset.name.c_str(), size);
  mark(card.preset.name);
  const bool hot = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, end, ImGui::GetColorU32(gui.theme().ground), gui.px(4));
  draw_picture(context, card, corner, {end.x, corner.y + gui.px(picture_height)});
  const ImVec2 text{corner.x + gui.px(8), corner.y + gui.px(picture_height + 5)};
  const float right = end.x - gui.px(8);
  const auto write = [&](float top, const ImVec4& colour, const char* words, const char* words_end) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::RenderTextEllipsis(&list, {text.x, top}, {right, top + line}, right, right, words, words_end, nullptr);
    ImGui::PopStyleColor();
  };
  // A long title has two lines.
  Gui::current().need(card.title);
  const char* const title_end = card.title.data() + card.title.size();
  const char* const first_end =
      ImGui::GetFont()->CalcWordWrapPositionA(1, card.title.data(), title_end, right - text.x);
  write(text.y, gui.theme().text, card.title.data(), first_end);
  const char* rest = first_end;
  while (rest != title_end && *rest == ' ') ++rest;
  float below = text.y + line;
  if (rest != title_end) {
    write(below, gui.theme().text, rest, title_end);
    below += line;
  }
  write(below + gui.px(2), gui.theme().faint, card.model.data(), card.model.data() + card.model.size());
  list.AddRect(corner, end, ImGui::GetColorU32(hot ? gui.theme().accent : gui.theme().edge), gui.px(4), 0,
               hot ? gui.px(2) : 1.0f);
  tooltip(card.title + "\n" + card.description + "\n\nClick: it opens and grows.");
  return pressed;
}

void GalleryPanel::draw_cards(PanelContext& context, const std::string& folder) {
  const Gui& gui = Gui::current();
  const float step = gui.px(card_width + card_gap);
  const int columns = std::max(1, static_cast<int>((ImGui::GetContentRegionAvail().x + gui.px(card_gap)) / step));
  int column = 0;
  for (const Card& card : cards_) {
    if (card.folder != folder) continue;
    if (column > 0) ImGui::SameLine(0, gui.px(card_gap));
    column = (column + 1) % columns;
    if (draw_card(context, card)) {
      context.leave("OPEN", session::Leaves::everything, [&context, path = card.preset.path] { grow(context, path); });
    }
    if (column == 0) ImGui::Dummy({1, gui.px(card_gap - 8)});
  }
  if (column != 0) ImGui::Dummy({1, gui.px(card_gap - 8)});
}

void GalleryPanel::draw(PanelContext& context) {
  if (!read_) read_cards(context.app);
  if (cards_.empty()) {
    explain("No presets were found in " + context.app.folders().presets.string() +
            ". The panel SETUP makes a terrain without one: press CREATE there.");
    return;
  }
  explain("Click one and it grows. Everything about it can be changed afterwards.");
  std::string folder;
  bool first = true;
  for (const Card& card : cards_) {
    if (!first && card.folder == folder) continue;
    folder = card.folder;
    if (folder.empty() || section(folder == "thesis" ? "From the thesis of Cimbura (2022)" : folder.c_str())) {
      draw_cards(context, folder);
    }
    first = false;
  }
}

}  // namespace

std::unique_ptr<Panel> make_gallery_panel() { return std::make_unique<GalleryPanel>(); }

}  // namespace erg::ui
