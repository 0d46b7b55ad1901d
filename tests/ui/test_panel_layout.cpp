// Every panel as a person sees it: nothing is cut off at the side. With ERG_PICTURES=FOLDER in the environment each is
// also written to FOLDER/NAME.png, which is where the pictures of docs/guide.md come from.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "flat_host.h"
#include "io/formats/png.h"
#include "panel_hand.h"
#include "picture_of_gui.h"
#include "ui/land/look_panel.h"
#include "ui/window/picture_panel.h"

namespace erg::test {

using forcing::WindInterval;
using io::write_png;
using picture::RgbImage;
using session::AppFolders;
using session::AppModel;
using sim::Config;
using ui::make_panels;
using ui::Panel;
using ui::Shell;

namespace {

bool pictures_wanted() { return std::getenv("ERG_PICTURES") != nullptr; }

/// A run with something to show under three seasons; for pictures, one with dunes.
void grow(PanelHand& panel) {
  const std::int64_t side = pictures_wanted() ? 128 : 32;
  Config config;
  config.title = "Barchan field";
  config.grid.set("nx", side);
  config.grid.set("ny", side);
  config.run.set("steps", std::int64_t{600});
  config.run.set("threads", std::int64_t{1});
  config.wind.intervals = {WindInterval{270, 3, 8, 100, {{0.6, 0.05}, {0.5, 0.95}}}, WindInterval{225, 8, 8, 50, {}},
                           WindInterval{292.5, 8, 4, 80, {}}};
  for (WindInterval& season : config.wind.intervals) season.spread = 10;
  panel.app.setup().replace(config);
  panel.app.create();
  panel.app.runner().run(pictures_wanted() ? 120 : 10);
  panel.app.runner().wait_until_still();
  panel.settle();
  panel.app.log().warning("dunes.json:7: unknown key \"wind_sped\"; did you mean \"wind_speed\"?");
  panel.app.log().error("hills.png: the picture is damaged; make it anew");
}

std::string file_name(std::string title) {
  for (char& letter : title) letter = letter == ' ' ? '_' : static_cast<char>(std::tolower(letter));
  return title + ".png";
}

/// How far the content of the panel's window reaches beyond its right edge, pixels.
float overhang(const char* title) {
  const ImGuiWindow* window = ImGui::FindWindowByName(title);
  return window->ContentSize.x - (window->Size.x - 2 * window->WindowPadding.x);
}

/// The panel's window, as high as its content.
RgbImage picture_of(PanelHand& panel, const char* title) {
  const ImGuiWindow* window = ImGui::FindWindowByName(title);
  const float content = window->ContentSize.y + 2 * window->WindowPadding.y;
  RgbImage picture(static_cast<int>(window->Size.x), static_cast<int>(std::min(window->Size.y, content)));
  picture.paste(picture_of_gui(panel.hand.gui(), ImGui::GetIO().DisplaySize), 0, 0);
  return picture;
}

void look_at(PanelHand& panel, const char* title) {
  panel.hand.move({-1, -1});
  panel.hand.frames(3);
  EXPECT_LE(overhang(title), 1) << title << " is cut off";
  if (const char* folder = std::getenv("ERG_PICTURES")) {
    write_png(std::filesystem::path(folder) / file_name(title), picture_of(panel, title), {});
  }
}

TEST(PanelLayout, NoPanelIsCutOffAtTheSide) {
  ui::ViewState view_state;
  ui::Bookmarks bookmarks{std::filesystem::path()};
  bookmarks.keep("over the lee", {});
  std::vector<std::unique_ptr<Panel>> panels = make_panels();
  panels.push_back(ui::make_look_panel(view_state, bookmarks));
  panels.push_back(ui::make_picture_panel([](const ui::PictureOrder&) {}));
  for (std::unique_ptr<Panel>& made : panels) {
    const std::string title = made->title();
    PanelHand panel(std::move(made));
    grow(panel);
    if (title == "SECTION") {
      panel.hand.click("PICK TWO POINTS");
      panel.click_terrain({4, 60});
      panel.click_terrain({124, 70});
    }
    if (title == "TEMPERATURE") {
      panel.app.setup().choose_model("snow_packing");
      panel.app.setup().set_course(*forcing::find_channel("temperature"), {-20, -2, {{0.5, 0.05}, {0.6, 0.9}}});
    }
    if (title == "COMPARE") {
      panel.hand.click("ADD A COPY");
      panel.app.setup().set("parameters", "p_sand", 0.8);
      panel.app.create();
      panel.app.runner().run(pictures_wanted() ? 60 : 10);
      panel.app.runner().wait_until_still();
      panel.settle();
    }
    look_at(panel, title.c_str());
  }
}

/// The whole interface over a flat terrain, with a session that a crash left.
struct WholeWindow {
  explicit WholeWindow(float scale) : app(folders()), hand([this] { draw(); }, {1280 * scale, 800 * scale}, scale) {
    app.settings().scale = scale;
    shell = std::make_unique<Shell>(app, host, hand.gui());
    Config config = small_config();
    config.title = "Barchan field";
    app.setup().replace(config);
    app.create();
    app.runner().wait_until_still();
    hand.frames(3);
  }
  ~WholeWindow() { shell.reset(); }

  AppFolders folders() {
    const AppFolders all{folder / "settings", folder / "state", {}};
    AppModel crashed(all);
    crashed.setup().set_title("Star dunes");
    crashed.create();
    crashed.runner().run(3);
    crashed.runner().wait_until_still();
    crashed.rescue();
    return all;
  }
  void draw() {
    app.tick();
    if (shell) shell->draw();
  }
  /// How far a window's content reaches beyond what is seen of it, pixels.
  static float hidden(const std::string& window) { return ImGui::FindWindowByName(window.c_str())->ScrollMax.x; }
  void look_at(const std::string& title) {
    hand.move({-1, -1});
    hand.frames(4);
    EXPECT_LE(hidden(title), 1) << title << " is cut off at scale " << hand.gui().scale();
    const char* const pictures = std::getenv("ERG_PICTURES");
    if (pictures == nullptr || hand.gui().scale() != 1) return;
    const ImGuiWindow* window = ImGui::FindWindowByName(title.c_str());
    RgbImage picture(static_cast<int>(window->Size.x), static_cast<int>(window->Size.y));
    picture.paste(picture_of_gui(hand.gui(), ImGui::GetIO().DisplaySize), -static_cast<int>(window->Pos.x),
                  -static_cast<int>(window->Pos.y));
    write_png(std::filesystem::path(pictures) / file_name(title), picture, {});
  }

  TemporaryFolder folder;
  AppModel app;
  FlatHost host;
  std::unique_ptr<Shell> shell;
  UiHarness hand;
};

TEST(PanelLayout, NoDialogAndNoColumnIsCutOffAtAnyScale) {
  for (const float scale : {1.0f, 1.5f, 2.0f}) {
    WholeWindow window(scale);
    EXPECT_LE(WholeWindow::hidden("##left"), 1) << scale;
    EXPECT_LE(WholeWindow::hidden("##right"), 1) << scale;
    for (const char* title :
         {ui::panel_title::keys, ui::panel_title::about, ui::panel_title::recovery, ui::picture_title}) {
      window.shell->open(title);
      window.look_at(title);
      window.shell->close(title);
      window.hand.frames(2);
    }
    window.shell->quit();
    window.look_at(ui::unsaved_title);
  }
}

TEST(PanelLayout, NoPanelIsCutOffBeforeThereIsATerrain) {
  for (std::unique_ptr<Panel>& made : make_panels()) {
    const std::string title = made->title();
    PanelHand panel(std::move(made));
    panel.hand.frames(3);
    EXPECT_LE(overhang(title.c_str()), 1) << title;
  }
}

}  // namespace
}  // namespace erg::test
