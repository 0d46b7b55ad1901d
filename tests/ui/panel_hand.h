// One panel over a view model of its own, without a window: what the panel is given, and what it asked of the window.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "../unit/temporary_folder.h"
#include "harness.h"
#include "session/app_model.h"
#include "ui/panels/panels.h"

namespace erg::test {

class PanelHand {
 public:
  /// Docks are 330 pixels wide, dialogs as they ask. `prepare` may put files into the folder before the app starts.
  explicit PanelHand(std::unique_ptr<ui::Panel> panel, const std::function<void(const TemporaryFolder&)>& prepare = {});

  TemporaryFolder folder;  ///< settings, state and presets lie in it; also the folder that browsers open in
  session::AppModel app;
  ui::TerrainPointer pointer;       ///< given to the panel in the next frames
  std::vector<std::string> opened;  ///< titles that the panel asked to open
  std::vector<std::string> closed;
  ui::TerrainTool tool = ui::TerrainTool::camera;  ///< that the panel asked for in the last frame
  std::vector<ui::TerrainMark> marks;

 private:
  std::unique_ptr<ui::Panel> panel_;

 public:
  UiHarness hand;

  /// A small terrain under the setup as it is, and the frames that show it.
  void create();
  /// Waits for the worker and draws what it has done.
  void settle();
  /// The left button goes down on a cell and up again.
  void click_terrain(session::CellPlace cell);

 private:
  void draw();
};

/// A config of few cells.
sim::Config small_config();

}  // namespace erg::test
