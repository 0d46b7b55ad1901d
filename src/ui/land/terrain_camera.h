// The camera in a person's hand: mouse and keys over the terrain.
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>
#include <string>

#include "picture/camera.h"
#include "render/camera.h"

namespace erg::ui {

/// What the camera must know of the terrain under it.
class TerrainGround {
 public:
  virtual ~TerrainGround() = default;
  /// The block of terrain, m.
  virtual render::TerrainBox box() const = 0;
  /// The point of the terrain that is seen at a place of the picture; none beside the terrain.
  virtual std::optional<Eigen::Vector3d> under(const picture::Camera& camera, render::PicturePoint point,
                                               double aspect) const = 0;
  /// Height of the terrain, m.
  virtual double height(double east, double north) const = 0;
};

/// What the hand does in one frame. Lengths are shares of the picture's height.
struct CameraInput {
  render::PicturePoint cursor = {};  ///< where the pointer is
  bool orbit = false;                ///< a drag that turns the camera round its target
  bool pan = false;                  ///< a drag that shifts the terrain
  bool look = false;                 ///< a drag that turns the view about the eye
  double right = 0;                  ///< how far the pointer went in this frame
  double up = 0;
  double wheel = 0;     ///< clicks of the wheel, positive nearer
  double forwards = 0;  ///< flying keys: -1, 0 or 1
  double sideways = 0;
  double rise = 0;
  double seconds = 0;  ///< since the last frame
};

/// Keeps a camera above the ground and within reach of the terrain while it is moved.
class TerrainCamera {
 public:
  const picture::Camera& camera() const { return camera_; }
  void set(const picture::Camera& camera) { camera_ = camera; }
  /// One of render's presets, or the whole terrain in sight from where one looks now ("frame").
  void choose(const std::string& preset, const render::TerrainBox& box, double aspect);
  /// Moves it. True when it moved.
  bool move(const CameraInput& input, const TerrainGround& ground, double aspect);

 private:
  void stay_near(const render::TerrainBox& box);

  picture::Camera camera_;
};

}  // namespace erg::ui
