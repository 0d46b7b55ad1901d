// What a panel is, and what the window offers it.
//
// A panel is a small class in a file of its own. The window draws frame, heading and scroll bar around it; the panel
// draws its content with the widgets of ui/widgets/widgets.h. It reads the view model (src/session) and tells it what
// to do, and knows neither OpenGL nor the window.
#pragma once

#include <imgui.h>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "session/app_model.h"

namespace erg::ui {

/// What the left mouse button does on the terrain.
enum class TerrainTool {
  camera,   ///< turns the view
  section,  ///< picks the two ends of a cross-section
  paint     ///< strokes a brush
};

/// The pointer on the terrain in this frame.
struct TerrainPointer {
  std::optional<session::CellPlace> cell;  ///< under the pointer; none beside the terrain or over a panel
  bool pressed = false;  ///< the left button went down on `cell` in this frame, with a tool other than camera
  bool held = false;     ///< it is down since
};

/// A line of markings that a panel wants to see over the terrain: the cross-section, the brush's rim.
struct TerrainMark {
  /// In cells, cell centres at whole numbers; joined by lines on the ground.
  std::vector<std::array<double, 2>> points;
  bool closed = false;  ///< the last is joined to the first
};

/// A key and what it does, for the help.
struct KeyHelp {
  std::string menu;  ///< where it stands in the menus: "Run"; "Terrain" for mouse and flying keys
  std::string keys;  ///< "Ctrl+O", "Space", "right drag"
  std::string what;
};

/// What a panel may use in a frame.
struct PanelContext {
  session::AppModel& app;
  TerrainPointer pointer;
  /// Set by panels while they are drawn; the window acts on it after the frame.
  TerrainTool tool = TerrainTool::camera;
  std::vector<TerrainMark> marks;
  /// Opens (or brings forward) the panel of this title; a dialog that is open stays open until closed.
  std::function<void(const std::string& title)> open;
  std::function<void(const std::string& title)> close;
  /// Does `act`, which leaves behind what is open; where work would be lost, only once the person has answered what is
  /// to become of it. `what` stands on the button that does it all the same: "QUIT". The context outlives the question.
  std::function<void(const std::string& what, session::Leaves leaves, std::function<void()> act)> leave;
  /// A picture for ImGui::Image: the PNG or JPEG at `path`, loaded once; null when it cannot be read, and in tests.
  std::function<ImTextureID(const std::filesystem::path& path)> picture;
  /// Every key and mouse movement of the window, from the one table that the menus are made of.
  std::vector<KeyHelp> keys;
  /// A dialog, a menu or a question has the keyboard: keys do nothing to the terrain.
  bool keys_taken = false;
};

/// Where a panel lies.
enum class Dock {
  left,   ///< a section of the left column
  right,  ///< a section of the right column
  dialog  ///< a window of its own over the terrain, opened from the menus or by PanelContext::open
};

/// A part of the interface.
class Panel {
 public:
  virtual ~Panel() = default;
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  /// Heading and name: "SETUP"; also the scope of its widgets in the widget map.
  virtual const char* title() const = 0;
  virtual Dock dock() const = 0;
  /// False while there is nothing to show: TEMPERATURE for a model of sand. A dialog that becomes wanted opens itself.
  virtual bool wanted(const PanelContext&) const { return true; }
  /// For dialogs: the size at scale 1, pixels.
  virtual ImVec2 size() const { return {640, 480}; }
  /// Draws its content.
  virtual void draw(PanelContext& context) = 0;

 protected:
  Panel() = default;
};

}  // namespace erg::ui
