// The whole interface without a window, over a small terrain.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "flat_host.h"
#include "harness.h"
#include "panel_hand.h"

namespace erg::test {

class ShellHand : public testing::Test {
 protected:
  TemporaryFolder folder;
  session::AppModel app{session::AppFolders{folder.path() / "settings", folder.path() / "state", {}}};
  FlatHost host;
  // The shell needs an ImGui context, which the harness makes; it is there from the first frame on.
  std::unique_ptr<ui::Shell> shell;
  UiHarness hand{[this] {
    app.tick();
    if (shell) shell->draw();
  }};

  void SetUp() override {
    shell = std::make_unique<ui::Shell>(app, host, hand.gui());
    hand.frames(2);
  }
  void TearDown() override { shell.reset(); }

  void create() {
    app.setup().replace(small_config());
    ASSERT_TRUE(app.create());
    settle();
  }
  // Until the worker has done what it was told, and rests.
  void settle() {
    app.runner().wait_until_still();
    hand.frames(3);
  }
  const session::Snapshot& now() { return app.now(); }
};

}  // namespace erg::test
