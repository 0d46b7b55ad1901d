// The terrain in the middle of the window: where it lies, what mouse and keys do on it, what is written over it.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "session/app_model.h"
#include "ui/land/terrain_overlay.h"
#include "ui/land/view_state.h"
#include "ui/panels/panel.h"

namespace erg::ui {

/// The ground of a run as it is on the screen; null before it was drawn.
using GroundOfRun = std::function<const TerrainGround*(std::size_t run)>;

/// Holds no terrain itself: it looks at the snapshot, and asks for the ground that was drawn.
class TerrainWindow {
 public:
  TerrainWindow(ViewState& view_state, GroundOfRun ground) : view_state_(view_state), ground_(std::move(ground)) {}

  /// Takes the rectangle of the window that is left for the terrain, and what the pointer does there. Fills in
  /// context.terrain.
  void take_input(PanelContext& context, WindowPart area);
  /// Draws over the terrain, after the panels have said what they want to see there.
  void draw_over(PanelContext& context);

  /// Where each run is drawn.
  const std::vector<WindowPart>& parts() const { return parts_; }
  /// The camera is being moved.
  bool restless() const { return restless_; }
  /// Notes of the renderer about how it drew.
  void set_notes(std::vector<std::string> notes) { notes_ = std::move(notes); }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  std::vector<TerrainPane> panes(const session::Snapshot& now) const;
  void take_wanted_view(const session::Snapshot& now, const std::vector<TerrainPane>& panes);
  void move_camera(const PanelContext& context, const TerrainPane& pane, bool hovered);
  void point(PanelContext& context, const TerrainPane& pane, bool hovered);
  void draw_terrains(const PanelContext& context, const std::vector<TerrainPane>& panes) const;
  void draw_captions(const PanelContext& context, const std::vector<TerrainPane>& panes) const;
  void draw_reading(const PanelContext& context, const TerrainPane& pane) const;
  void draw_empty(PanelContext& context) const;
  void draw_troubles(const PanelContext& context) const;

  ViewState& view_state_;
  GroundOfRun ground_;
  WindowPart area_;
  std::array<double, 2> extent_{};  // of the terrain that the camera was last placed for, m
  std::uint64_t creations_ = 0;     // of the runs that the camera was last placed for
  std::vector<WindowPart> parts_;
  std::vector<std::string> notes_;
  std::size_t under_pointer_ = 0;  // the part
  bool restless_ = false;
  bool active_ = false;  // a button is down that went down on the terrain
  TerrainTool tool_ = TerrainTool::camera;
};

}  // namespace erg::ui
