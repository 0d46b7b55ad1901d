#include "panel_hand.h"

#include "ui/widgets/widgets.h"

namespace erg::test {

using sim::Config;
using ui::Panel;

namespace {

ImVec2 size_of(const Panel& panel) { return panel.dock() == ui::Dock::dialog ? panel.size() : ImVec2{330, 1500}; }

session::AppFolders folders_in(const TemporaryFolder& folder,
                               const std::function<void(const TemporaryFolder&)>& prepare) {
  for (const char* name : {"settings", "state", "presets"}) std::filesystem::create_directory(folder / name);
  if (prepare) prepare(folder);
  return {folder / "settings", folder / "state", folder / "presets"};
}

}  // namespace

Config small_config() {
  Config config;
  config.grid.set("nx", std::int64_t{32});
  config.grid.set("ny", std::int64_t{24});
  config.run.set("threads", std::int64_t{1});
  return config;
}

PanelHand::PanelHand(std::unique_ptr<Panel> panel, const std::function<void(const TemporaryFolder&)>& prepare)
    : app(folders_in(folder, prepare)),
      panel_(std::move(panel)),
      hand([this] { draw(); }, size_of(*panel_).x > 700 ? size_of(*panel_) : ImVec2{800, size_of(*panel_).y}) {}

void PanelHand::draw() {
  if (app.settings().last_folder.empty()) app.settings().last_folder = folder.path().string();
  app.tick();
  ui::PanelContext context{app, pointer, ui::TerrainTool::camera, {}, {}, {}, {}, {}, {}};
  context.open = [this](const std::string& title) { opened.push_back(title); };
  context.close = [this](const std::string& title) { closed.push_back(title); };
  context.leave = [](const std::string&, session::Leaves, const std::function<void()>& act) { act(); };
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(size_of(*panel_));
  ImGui::Begin(panel_->title(), nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove);
  {
    const ui::WidgetScope scope(panel_->title());
    panel_->draw(context);
  }
  ImGui::End();
  tool = context.tool;
  marks = context.marks;
}

void PanelHand::create() {
  app.setup().replace(small_config());
  app.create();
  settle();
}

void PanelHand::settle() {
  hand.frames(2);
  app.runner().wait_for_commands();
  hand.frames(2);
}

void PanelHand::click_terrain(session::CellPlace cell) {
  pointer = {cell, true, true};
  hand.frames();
  pointer = {cell, false, false};
  hand.frames();
}

}  // namespace erg::test
