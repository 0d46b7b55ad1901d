// Still pictures of the terrain drawn beside the window: where the processor draws, a careful picture takes seconds,
// and the window must not stand still for them.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "render/camera.h"
#include "render/look.h"
#include "render/quality.h"
#include "session/snapshot.h"

namespace erg::ui {

/// What is to be drawn: every run with one look, from one camera.
struct StillOrder {
  struct Part {
    session::RunSnapshot run;
    int width = 1;  ///< pixels
    int height = 1;
  };
  std::vector<Part> parts;
  render::Look look;
  picture::Camera camera;
  render::RenderQuality quality;
};

/// A run as it was drawn: red, green, blue, opacity, rows from below.
struct StillPicture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
  std::vector<std::string> notes;  ///< what a person should know
};

/// Draws on a thread of its own, in an OpenGL context of its own, and lets the window's thread go first.
class StillPainter {
 public:
  /// To be made before the window: both load their functions of OpenGL into the same table.
  StillPainter();
  /// Waits for the picture under way.
  ~StillPainter();
  StillPainter(const StillPainter&) = delete;
  StillPainter& operator=(const StillPainter&) = delete;

  /// Whether it has a context to draw in; EGL gives it.
  bool works() const { return works_; }
  /// Begins to draw. Only while it is not busy.
  void order(StillOrder order);
  /// An order is being carried out.
  bool busy() const;
  /// The pictures of the last order, once: all of them, or none when drawing them failed. Nothing while there is none
  /// to be had.
  std::optional<std::vector<StillPicture>> take();

 private:
  void work();
  void draw_orders();

  bool works_ = false;
  mutable std::mutex mutex_;
  std::condition_variable told_;
  bool ready_ = false;
  bool stopping_ = false;
  bool drawing_ = false;
  std::optional<StillOrder> order_;
  std::optional<std::vector<StillPicture>> drawn_;
  std::thread thread_;
};

}  // namespace erg::ui
