// Every panel as a person sees it: nothing is cut off at the side. With ERG_PICTURES=FOLDER in the environment each is
// also written to FOLDER/NAME.png, which is where the pictures of docs/guide.md come from.
#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "io/image.h"
#include "panel_hand.h"
#include "picture_of_gui.h"

namespace erg::test {
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
  config.wind.seasons = {Season{270, 3, 8, 100, {{0.6, 0.05}, {0.5, 0.95}}}, Season{225, 8, 8, 50, {}},
                         Season{292.5, 8, 4, 80, {}}};
  panel.studio.setup().replace(config);
  panel.studio.create();
  panel.studio.runner().run(pictures_wanted() ? 120 : 10);
  panel.studio.runner().wait_until_still();
  panel.settle();
  panel.studio.log().warning("dunes.json:7: unknown key \"wind_sped\"; did you mean \"wind_speed\"?");
  panel.studio.log().error("hills.png: the picture is damaged; make it anew");
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
  for (std::unique_ptr<Panel>& made : make_panels()) {
    const std::string title = made->title();
    PanelHand panel(std::move(made));
    grow(panel);
    if (title == "SECTION") {
      panel.hand.click("PICK TWO POINTS");
      panel.click_land({4, 60});
      panel.click_land({124, 70});
    }
    if (title == "COMPARE") {
      panel.hand.click("ADD A COPY");
      panel.studio.setup().set("parameters", "p_sand", 0.8);
      panel.studio.create();
      panel.studio.runner().run(pictures_wanted() ? 60 : 10);
      panel.studio.runner().wait_until_still();
      panel.settle();
    }
    look_at(panel, title.c_str());
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
