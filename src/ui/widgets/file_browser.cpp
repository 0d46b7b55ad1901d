#include "ui/widgets/file_browser.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/widgets/widgets.h"

namespace erg::ui {

using session::AppModel;
using session::SaveQuestion;
using session::Settings;
using session::typed_path;

namespace {

namespace fs = std::filesystem;

std::string size_text(std::uint64_t bytes) {
  constexpr const char* units[] = {"B", "kB", "MB", "GB", "TB"};
  double size = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (size >= 1000 && unit + 1 < std::size(units)) {
    size /= 1000;
    ++unit;
  }
  char text[32];
  std::snprintf(text, sizeof text, unit == 0 || size >= 100 ? "%.0f %s" : "%.1f %s", size, units[unit]);
  return text;
}

/// A line of a list; true when it was clicked.
bool pick(const std::string& label, bool selected, const std::string& hint, ImGuiSelectableFlags flags = 0) {
  const bool picked = ImGui::Selectable(label.c_str(), selected, flags);
  mark(label);
  tooltip(hint);
  return picked;
}

}  // namespace

void FileBrowser::start(const Settings& settings, const std::string& name) {
  fs::path folder = settings.last_folder;
  std::error_code failed;
  if (folder.empty() || !fs::is_directory(folder, failed)) folder = fs::current_path(failed);
  filter_.clear();
  name_ = name;
  refusal_.clear();
  asked_about_.clear();
  cancelled_ = false;
  go_to(folder);
}

void FileBrowser::go_to(const fs::path& folder) {
  listing_ = session::list_folder(folder, task_.endings, filter_);
  path_text_ = listing_.folder.string();
  asked_about_.clear();
}

void FileBrowser::draw_places(AppModel& app) {
  const Gui& gui = Gui::current();
  ImGui::BeginChild("places", {gui.px(190), -2.2f * ImGui::GetFrameHeightWithSpacing()}, true);
  {
    const WidgetScope scope("places");
    explain("Places");
    for (const session::Place& place : session::places(app.folders().presets)) {
      if (pick(place.label, place.path == listing_.folder, place.path.string())) go_to(place.path);
    }
  }
  if (!task_.saving) {
    const WidgetScope scope("recent");
    ImGui::Spacing();
    explain("Recent");
    for (const std::string& recent : app.settings().recent) {
      const fs::path path = recent;
      if (pick(path.filename().string(), false, recent)) choose(path);
    }
    if (app.settings().recent.empty()) explain("Nothing yet. The gallery has presets to start from.");
  }
  ImGui::EndChild();
}

void FileBrowser::draw_path_line() {
  Gui& gui = Gui::current();
  gui.need(path_text_);
  if (button("UP", {.tooltip = "The folder above."})) go_to(listing_.folder.parent_path());
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-gui.px(190));
  const bool typed = ImGui::InputText("##path", &path_text_, ImGuiInputTextFlags_EnterReturnsTrue);
  mark("path");
  tooltip("Type a folder or a whole path and press Enter. ~ is your home.");
  if (typed) {
    const fs::path path = typed_path(path_text_, listing_.folder);
    std::error_code failed;
    if (fs::is_directory(path, failed)) {
      go_to(path);
    } else {
      choose(path);
    }
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputTextWithHint("##filter", "filter", &filter_)) go_to(listing_.folder);
  mark("filter");
  tooltip("Only names that contain this.");
}

std::optional<fs::path> FileBrowser::draw_rows() {
  const WidgetScope scope("files");
  std::optional<fs::path> next;
  for (const session::FolderEntry& entry : listing_.entries) {
    ImGui::TableNextColumn();
    const std::string label = entry.folder ? entry.name + "/" : entry.name;
    constexpr ImGuiSelectableFlags row = ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick;
    if (pick(label, !entry.folder && entry.name == name_, "", row)) {
      if (entry.folder) {
        next = entry.path;
      } else {
        name_ = entry.name;
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) choose(entry.path);
      }
    }
    ImGui::TableNextColumn();
    if (!entry.folder) ImGui::TextDisabled("%s", size_text(entry.bytes).c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", entry.changed.c_str());
  }
  return next;
}

void FileBrowser::draw_entries() {
  const float below = (asked_about_.empty() ? 2.2f : 3.4f) * ImGui::GetFrameHeightWithSpacing();
  constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter |
                                    ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("files", 3, flags, {0, -below})) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("name", 0, 4);
  ImGui::TableSetupColumn("size", 0, 1.1f);
  ImGui::TableSetupColumn("changed", 0, 2);
  ImGui::TableHeadersRow();
  const std::optional<fs::path> next = draw_rows();
  ImGui::EndTable();
  if (next) go_to(*next);
}

void FileBrowser::draw_name_line() {
  const float buttons = Gui::current().px(210);
  Gui::current().need(name_);
  ImGui::SetNextItemWidth(-buttons);
  const bool entered = ImGui::InputTextWithHint("##name", task_.saving ? "name of the file" : "a file from above",
                                                &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  mark("name");
  ImGui::SameLine();
  const float half = share_of_width(2);
  cancelled_ = button("CANCEL", {.size = {half, 0}}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  ImGui::SameLine();
  const bool pressed = button(task_.action.c_str(), {.unavailable = name_.empty() ? "Choose or type a file first." : "",
                                                     .look = ButtonLook::accent,
                                                     .size = {half, 0}});
  if ((pressed || entered) && !name_.empty()) choose(typed_path(name_, listing_.folder));
}

void FileBrowser::draw_question() {
  const Theme& theme = Gui::current().theme();
  if (!refusal_.empty()) say(refusal_, theme.lost);
  if (!listing_.problem.empty()) say(listing_.problem, theme.lost);
  if (asked_about_.empty()) return;
  say(asked_about_.filename().string() + " is there already. Replace it? What it holds would be lost.", theme.lost);
  if (button("REPLACE")) {
    chosen_ = asked_about_;
    asked_about_.clear();
  }
  ImGui::SameLine();
  if (button("KEEP IT", {.look = ButtonLook::accent})) asked_about_.clear();
}

void FileBrowser::choose(const fs::path& path) {
  refusal_.clear();
  asked_about_.clear();
  std::error_code failed;
  if (fs::is_directory(path, failed)) return go_to(path);
  if (!task_.saving) {
    if (fs::is_regular_file(path, failed)) {
      chosen_ = path;
    } else {
      refusal_ = path.string() + " is not there.";
    }
    return;
  }
  const fs::path file = task_.endings.empty() ? path : session::with_ending(path, task_.endings.front());
  switch (session::save_question(file)) {
    case SaveQuestion::none:
      chosen_ = file;
      break;
    case SaveQuestion::overwrite:
      asked_about_ = file;
      break;
    case SaveQuestion::no_folder:
      refusal_ = "There is no folder " + file.parent_path().string() + ".";
      break;
    case SaveQuestion::is_folder:
      refusal_ = file.string() + " is a folder.";
      break;
    case SaveQuestion::no_name:
      refusal_ = "Type a name first.";
      break;
  }
}

std::optional<fs::path> FileBrowser::draw(AppModel& app) {
  if (listing_.folder.empty()) start(app.settings(), name_);
  chosen_.reset();
  draw_places(app);
  ImGui::SameLine();
  ImGui::BeginGroup();
  draw_path_line();
  draw_entries();
  draw_question();
  ImGui::EndGroup();
  draw_name_line();
  if (chosen_) {
    app.settings().last_folder = chosen_->parent_path().string();
    listing_ = {};  // what it showed may change with what is done now
  }
  return chosen_;
}

void FilePopup::ask(const Settings& settings, const std::string& name) {
  browser_.start(settings, name);
  opening_ = true;
}

std::optional<fs::path> FilePopup::draw(AppModel& app) {
  const Gui& gui = Gui::current();
  const char* title = browser_.task().title.c_str();
  if (opening_) ImGui::OpenPopup(title);
  opening_ = false;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({gui.px(760), gui.px(480)});
  constexpr ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoScrollbar;
  if (!ImGui::BeginPopupModal(title, nullptr, flags)) return {};
  std::optional<fs::path> chosen;
  {
    const WidgetScope scope(title);
    chosen = browser_.draw(app);
  }
  if (chosen || browser_.cancelled()) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return chosen;
}

}  // namespace erg::ui
