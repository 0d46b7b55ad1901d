// The terrain's pictures: one for each run, drawn into memory of the graphics card when something changed, and copied
// into the window each frame.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/config/provenance.h"
#include "render/renderer.h"
#include "session/snapshot.h"
#include "ui/land/still_painter.h"
#include "ui/land/terrain_camera.h"

namespace erg::ui {

/// The view of a run for the renderer. `snapshot_run` must outlive it.
render::TerrainView view_of_run(const session::RunSnapshot& snapshot_run);

/// A part of the window, pixels from its left upper corner.
struct WindowPart {
  int left = 0;
  int top = 0;
  int width = 1;
  int height = 1;
  double aspect() const { return static_cast<double>(width) / height; }
  bool operator==(const WindowPart&) const = default;
};

/// Lives with one OpenGL context, which must be current whenever it is used and when it goes.
class TerrainPanes {
 public:
  /// `software`: the processor draws. `stills`, which must outlive it, then draws the pictures at rest; null: this
  /// thread does.
  explicit TerrainPanes(bool software, StillPainter* stills = nullptr);
  ~TerrainPanes();
  TerrainPanes(const TerrainPanes&) = delete;
  TerrainPanes& operator=(const TerrainPanes&) = delete;

  /// Draws the runs of a snapshot, each into its part of the window's frame buffer, whose height is given. `restless`:
  /// the camera is being moved. Returns what a person should know.
  std::vector<std::string> draw(const session::Snapshot& snapshot, const render::Look& look,
                                const picture::Camera& camera, const std::vector<WindowPart>& parts, int window_height,
                                bool restless);

  /// A picture is still coarser than it will be, and the next frame can do something about it.
  bool unfinished() const;

  /// The ground of a run as it was drawn last; null before.
  const TerrainGround* ground(std::size_t run) const;

  /// Draws a run with all there is.
  render::Picture picture(const session::RunSnapshot& run, const render::Look& look, const picture::Camera& camera,
                          const render::PictureSize& size);

 private:
  struct Pane;
  void draw_pane(Pane& pane, const session::RunSnapshot& run, const render::Look& look, const picture::Camera& camera,
                 bool restless);
  void paint(Pane& pane, const session::RunSnapshot& run, const render::Look& look, const picture::Camera& camera,
             bool fine);
  void refine(const session::Snapshot& snapshot, const render::Look& look, const picture::Camera& camera);
  void order_stills(const session::Snapshot& snapshot, const render::Look& look, const picture::Camera& camera);
  bool take_stills(std::vector<StillPicture> pictures);
  bool rested() const;
  void show(const Pane& pane, int window_height) const;

  bool software_;
  StillPainter* stills_;
  std::vector<std::unique_ptr<Pane>> panes_;
};

}  // namespace erg::ui
