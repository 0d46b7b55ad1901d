// Random input on the whole interface without a window: no crash, and no slab lost whatever was pressed.
#include <gtest/gtest.h>

#include <string>

#include "../unit/temporary_folder.h"
#include "flat_host.h"
#include "harness.h"
#include "io/config/config_file.h"
#include "models/model.h"
#include "monkey.h"
#include "panel_hand.h"

namespace erg::test {

using session::AppModel;
using ui::Shell;

namespace {

/// One small preset a model, for the gallery.
void write_small_presets(const std::filesystem::path& folder) {
  std::filesystem::create_directory(folder);
  for (const models::ModelType& type : models::catalogue()) {
    sim::Config config(type.info.key);
    config.title = "small " + type.info.key;
    config.description = "Small.";
    config.grid.set("nx", std::int64_t{32});
    config.grid.set("ny", std::int64_t{24});
    config.run.set("threads", std::int64_t{2});
    io::write_config(folder / (type.info.key + ".json"), config);
  }
}

class MonkeyAtTheShell : public testing::TestWithParam<unsigned> {
 protected:
  const ImVec2 screen{1280, 800};

  TemporaryFolder folder;
  std::unique_ptr<AppModel> app;
  FlatHost host;
  std::unique_ptr<Shell> shell;
  UiHarness hand{[this] {
                   if (!shell) return;
                   app->tick();
                   shell->draw();
                 },
                 screen};

  void SetUp() override {
    write_small_presets(folder / "presets");
    app = std::make_unique<AppModel>(session::AppFolders{folder / "settings", folder / "state", folder / "presets"});
    app->settings().last_folder = folder.path().string();
    app->setup().replace(small_config());
    shell = std::make_unique<Shell>(*app, host, hand.gui());
    ASSERT_TRUE(app->create());
    app->runner().wait_for_commands();
  }
  void TearDown() override { shell.reset(); }

  std::vector<Spot> spots() {
    std::vector<Spot> all;
    for (const ui::WidgetPlace& place : hand.gui().widgets().places()) {
      all.push_back({place.name, place.low.x, place.low.y, place.high.x, place.high.y});
    }
    return all;
  }

  void carry_out(const Deed& deed) {
    ImGuiIO& io = ImGui::GetIO();
    switch (deed.kind) {
      case Deed::Kind::move:
        return hand.move({deed.x, deed.y});
      case Deed::Kind::press:
        return hand.press(deed.button);
      case Deed::Kind::release:
        return hand.release(deed.button);
      case Deed::Kind::wheel:
        return hand.scroll(static_cast<float>(deed.lines));
      case Deed::Kind::type:
        return hand.type(deed.text);
      case Deed::Kind::key:
        io.KeyCtrl = deed.key.ctrl;
        io.KeyMods = deed.key.ctrl ? ImGuiKeyModFlags_Ctrl : ImGuiKeyModFlags_None;
        hand.key(deed.key.place);
        io.KeyCtrl = false;
        io.KeyMods = ImGuiKeyModFlags_None;
    }
  }
};
INSTANTIATE_TEST_SUITE_P(Seeds, MonkeyAtTheShell, testing::Values(1u, 2u, 3u));

TEST_P(MonkeyAtTheShell, BreaksNothing) {
  Monkey monkey(GetParam(), screen.x, screen.y);
  for (int deed = 0; deed < 1500; ++deed) {
    carry_out(monkey.next(spots()));
    shell->apply_settings();
    for (const session::RunSnapshot& run : app->now().runs) ASSERT_EQ(run.mass_drift(), 0) << "after deed " << deed;
  }
  // The worker still does what it is told.
  app->runner().pause();
  app->setup().replace(small_config());
  app->runner().create({small_config()});
  app->runner().step();
  app->runner().wait_until_still();
  EXPECT_EQ(app->runner().snapshot()->step(), 1) << app->log().text();
}

}  // namespace
}  // namespace erg::test
