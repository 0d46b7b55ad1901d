#include "ui/window/shell.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "ui/land/look_panel.h"
#include "ui/panels/panels.h"
#include "ui/widgets/widgets.h"
#include "ui/window/picture_panel.h"

namespace erg::ui {

using session::Leaves;

namespace {

// Widths at scale 1, pixels.
constexpr float left_width = 330;
constexpr float right_width = 310;
constexpr float narrowest_column = 220;
constexpr float widest_column = 640;
constexpr float edge_width = 5;

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string path_of_bookmarks(const session::AppFolders& folders) {
  return folders.settings.empty() ? std::string() : (folders.settings / "views").string();
}

}  // namespace

Shell::Shell(session::AppModel& app, Host& host, Gui& gui)
    : app_(app),
      host_(host),
      gui_(gui),
      bookmarks_(path_of_bookmarks(app.folders())),
      terrain_(view_state_, [&host](std::size_t run) { return host.ground(run); }),
      context_{.app = app,
               .pointer = {},
               .tool = TerrainTool::camera,
               .marks = {},
               .open = [this](const std::string& title) { open(title); },
               .close = [this](const std::string& title) { close(title); },
               .leave = [this](const std::string& what, Leaves leaves,
                               std::function<void()> act) { leave(what, leaves, std::move(act)); },
               .picture = [&host](const std::filesystem::path& path) { return host.picture(path); },
               .keys = {},
               .keys_taken = false} {
  panels_ = make_panels();
  panels_.push_back(make_look_panel(view_state_, bookmarks_));
  // LOOK stands first in its column.
  const auto first =
      std::find_if(panels_.begin(), panels_.end(), [](const auto& p) { return p->dock() == Dock::right; });
  std::rotate(first, panels_.end() - 1, panels_.end());
  panels_.push_back(make_picture_panel([&host](const PictureOrder& order) { host.save_picture(order); }));
  panels_.push_back(make_unsaved_panel(parting_));
  make_actions();
  context_.keys = key_help(actions_);
  apply_settings();
}

Shell::~Shell() = default;

void Shell::apply_settings() {
  const session::Settings& settings = app_.settings();
  if ((gui_.theme().kind == ThemeKind::dark) != settings.dark) {
    gui_.set_theme(settings.dark ? ThemeKind::dark : ThemeKind::light);
  }
  gui_.set_scale(static_cast<float>(settings.scale > 0 ? settings.scale : host_.suggested_scale()));
}

float Shell::layout(const std::string& name, float standard) const {
  const auto& kept = app_.settings().layout;
  const auto found = kept.find(name);
  return found == kept.end() ? standard : static_cast<float>(found->second);
}

void Shell::set_layout(const std::string& name, float value) { app_.settings().layout[name] = value; }

void Shell::open(const std::string& title) {
  for (const auto& panel : panels_) {
    if (panel->title() != title) continue;
    if (panel->dock() != Dock::dialog) {
      set_layout("fold " + title, 1);
      columns_shown_ = true;
      return;
    }
    if (!is_open(title)) open_dialogs_.push_back(title);
    to_front_ = title;
  }
}

void Shell::close(const std::string& title) { std::erase(open_dialogs_, title); }

void Shell::leave(const std::string& what, Leaves leaves, std::function<void()> act) {
  if (!app_.unsaved_work(leaves)) return act();
  parting_ = Parting{what, leaves, std::move(act)};
  open(unsaved_title);
}

void Shell::quit() {
  leave("QUIT", Leaves::everything, [this] { host_.close(); });
}

bool Shell::is_open(const std::string& title) const {
  return std::find(open_dialogs_.begin(), open_dialogs_.end(), title) != open_dialogs_.end();
}

std::string Shell::why_nothing_to_save() const {
  return app_.now().has_runs() ? std::string() : "There is no terrain yet.";
}

void Shell::draw() {
  if (app_.take_failed_creation()) open(panel_title::log);
  close_menu_on_escape();
  // While a dialog, a menu or a question is open, keys are for it: none of them reaches the terrain behind.
  context_.keys_taken = dialog_has_keys_ || popup_was_open_ || is_open(unsaved_title);
  if (!context_.keys_taken) press_keys(actions_);
  draw_menu_bar();
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const float top = ImGui::GetFrameHeight();
  const float line = ImGui::GetFrameHeightWithSpacing();
  const float foot = line + ImGui::GetTextLineHeightWithSpacing() + gui_.px(14);
  const float high = whole.y - top - foot;
  // Columns never leave less than a third of the window to the terrain.
  const float most = whole.x / 3;
  const float left = columns_shown_ ? std::min(gui_.px(layout("left width", left_width)), most) : 0;
  const float right = columns_shown_ ? std::min(gui_.px(layout("right width", right_width)), most) : 0;
  terrain_.take_input(
      context_, {static_cast<int>(left), static_cast<int>(top), std::max(static_cast<int>(whole.x - left - right), 1),
                 std::max(static_cast<int>(high), 1)});
  if (columns_shown_) {
    draw_column(Dock::left, "left", 0, top, left, high);
    draw_column_edge("left", left - gui_.px(edge_width), top, high, 1);
    draw_column(Dock::right, "right", whole.x - right, top, right, high);
    draw_column_edge("right", whole.x - right, top, high, -1);
  }
  draw_foot(top + high, foot);
  draw_dialogs();
  terrain_.draw_over(context_);
  if (const std::string missing = gui_.take_missing_letters(); !missing.empty()) {
    app_.log().warning("no font on this machine has the letters " + missing +
                       ": install one that does, such as fonts-noto-core or fonts-noto-cjk");
  }
}

/// ImGui leaves menus and lists of choices open on Escape, and they would take the next click. A question in the way of
/// everything (a modal one) closes itself.
void Shell::close_menu_on_escape() {
  ImGuiContext& context = *ImGui::GetCurrentContext();
  if (context.OpenPopupStack.empty() || !ImGui::IsKeyPressed(keys::escape, false)) return;
  const ImGuiWindow* const top = context.OpenPopupStack.back().Window;
  if (top != nullptr && (top->Flags & ImGuiWindowFlags_Modal) != 0) return;
  ImGui::ClosePopupToLevel(context.OpenPopupStack.Size - 1, true);
}

void Shell::draw_menu_bar() {
  if (!ImGui::BeginMainMenuBar()) return;
  ImGui::TextColored(gui_.theme().accent, "Erg");
  draw_menus(actions_);
  std::string title = app_.title();
  if (app_.unsaved()) title += "   \u2022 unsaved";
  gui_.need(title);
  const float wide = ImGui::CalcTextSize(title.c_str()).x + gui_.px(16);
  const float room = ImGui::GetWindowWidth() - wide;
  if (room > ImGui::GetCursorPosX()) {
    ImGui::SetCursorPosX(room);
    ImGui::TextColored(gui_.theme().faint, "%s", title.c_str());
    mark("title");
  }
  ImGui::EndMainMenuBar();
}

void Shell::draw_column(Dock dock, const char* name, float left, float top, float width, float height) {
  ImGui::SetNextWindowPos({left, top});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin((std::string("##") + name).c_str(), nullptr, fixed | ImGuiWindowFlags_AlwaysVerticalScrollbar);
  for (const auto& panel : panels_) {
    if (panel->dock() == dock && panel->wanted(context_)) draw_panel_of_column(*panel);
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

void Shell::draw_panel_of_column(Panel& panel) {
  const std::string fold = std::string("fold ") + panel.title();
  const WidgetScope scope(panel.title());
  // Of the right column only LOOK is open at first, so that nothing needs scrolling.
  const bool open_at_first = panel.dock() == Dock::left || panel.title() == std::string_view(look_title);
  const bool was_open = layout(fold, open_at_first ? 1.0f : 0.0f) != 0;
  ImGui::SetNextItemOpen(was_open);
  ImGui::PushFont(gui_.heading_font());
  const bool open = ImGui::CollapsingHeader(panel.title());
  ImGui::PopFont();
  mark("fold");
  if (open != was_open) set_layout(fold, open ? 1 : 0);
  if (!open) return;
  panel.draw(context_);
  ImGui::Dummy({0, gui_.px(6)});
}

void Shell::draw_column_edge(const char* name, float left, float top, float height, float sign) {
  ImGui::SetNextWindowPos({left, top});
  ImGui::SetNextWindowSize({gui_.px(edge_width), height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  const std::string id = std::string("##edge ") + name;
  ImGui::Begin(id.c_str(), nullptr,
               (fixed & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNav);
  ImGui::InvisibleButton("edge", {gui_.px(edge_width), height});
  mark(std::string("edge ") + name);
  const std::string key = std::string(name) + " width";
  const float standard = sign > 0 ? left_width : right_width;
  if (ImGui::IsItemActive() && ImGui::GetIO().MouseDelta.x != 0) {
    const float width = layout(key, standard) + sign * ImGui::GetIO().MouseDelta.x / gui_.scale();
    set_layout(key, std::clamp(width, narrowest_column, widest_column));
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) set_layout(key, standard);
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::GetWindowDrawList()->AddRectFilled({left, top}, {left + gui_.px(2), top + height},
                                              ImGui::GetColorU32(gui_.theme().accent));
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

void Shell::draw_foot(float top, float height) {
  ImGui::SetNextWindowPos({0, top});
  ImGui::SetNextWindowSize({ImGui::GetIO().DisplaySize.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::Begin("##foot", nullptr, fixed | ImGuiWindowFlags_NoScrollbar);
  run_bar_.draw(app_);
  if (draw_status(app_, host_.frames_per_second(), terrain_.notes())) open(panel_title::log);
  ImGui::End();
  ImGui::PopStyleVar();
}

void Shell::draw_dialogs() {
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  // Escape closes the dialog that has the keyboard; when none has it, the one opened last.
  const bool escape = ImGui::IsKeyPressed(keys::escape, false) && !ImGui::IsAnyItemActive() && !popup_was_open_;
  popup_was_open_ = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
  const std::string last = dialog_has_keys_ || open_dialogs_.empty() ? std::string() : open_dialogs_.back();
  dialog_has_keys_ = false;
  for (const auto& panel : panels_) {
    if (panel->dock() != Dock::dialog || !is_open(panel->title())) continue;
    const ImVec2 size = panel->size();
    ImGui::SetNextWindowSize({std::min(gui_.px(size.x), whole.x), std::min(gui_.px(size.y), whole.y)},
                             ImGuiCond_Appearing);
    ImGui::SetNextWindowPos({0.5f * whole.x, 0.5f * whole.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    if (to_front_ == panel->title()) ImGui::SetNextWindowFocus();
    bool stays = true;
    const bool shown =
        ImGui::Begin(panel->title(), &stays, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
    {
      const WidgetScope scope(panel->title());
      if (shown) panel->draw(context_);
    }
    const bool has_keys = ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    dialog_has_keys_ = dialog_has_keys_ || has_keys;
    ImGui::End();
    if (!stays || (escape && (has_keys || panel->title() == last))) close(panel->title());
  }
  to_front_.clear();
}

}  // namespace erg::ui
