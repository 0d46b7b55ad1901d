#include "ui/land/land_camera.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace erg::ui {

using render::fly;
using render::LandBox;
using render::pan;

namespace {

constexpr double degrees_per_height = 180;  // a drag over the whole picture turns the camera half round
constexpr double zoom_per_click = 0.85;
constexpr double flight = 0.5;      // of the distance to the target, each second
constexpr double clearance = 0.01;  // of the land's shorter side, above the ground
constexpr double farthest = 20;     // times the land's longer side
constexpr double nearest = 1e-3;

}  // namespace

void LandCamera::choose(const std::string& preset, const LandBox& land, double aspect) {
  if (preset != "frame") {
    camera_ = render::camera_preset(preset, land, aspect);
    return;
  }
  const Eigen::Vector3d middle = land.middle();
  camera_.target = {middle.x(), middle.y(), middle.z()};
  const double across = std::hypot(land.east, land.north) / std::min(1.0, aspect);
  camera_.distance = 0.5 * across / std::tan(radians(0.5 * camera_.opening));
}

bool LandCamera::move(const CameraInput& input, const LandGround& ground, double aspect) {
  const picture::Camera before = camera_;
  const LandBox land = ground.box();
  if (input.orbit) render::orbit(camera_, -degrees_per_height * input.right, -degrees_per_height * input.up);
  if (input.look) render::look_around(camera_, degrees_per_height * input.right, degrees_per_height * input.up);
  if (input.pan) pan(camera_, -input.right, -input.up);
  if (input.wheel != 0) {
    const Eigen::Vector3d middle(camera_.target[0], camera_.target[1], camera_.target[2]);
    const Eigen::Vector3d point = ground.under(camera_, input.cursor, aspect).value_or(middle);
    render::zoom(camera_, std::pow(zoom_per_click, input.wheel), point);
  }
  const double speed = flight * camera_.distance * input.seconds;
  if (input.forwards != 0 && camera_.orthographic) {
    pan(camera_, 0, flight * input.seconds * input.forwards);
  } else if (input.forwards != 0) {
    fly(camera_, speed * input.forwards, 0, 0);
  }
  if (input.sideways != 0) fly(camera_, 0, speed * input.sideways, 0);
  if (input.rise != 0) fly(camera_, 0, 0, speed * input.rise);
  if (camera_ == before) return false;
  stay_near(land);
  const double keep = clearance * std::min(land.east, land.north);
  if (!camera_.orthographic) {
    render::keep_above(
        camera_, [&](double east, double north) { return ground.height(east, north); }, keep);
  }
  return camera_ != before;
}

void LandCamera::stay_near(const LandBox& land) {
  const double side = std::max(land.east, land.north);
  camera_.distance = std::clamp(camera_.distance, nearest * side, farthest * side);
  // Where the target lies outside, half a land's width away is far enough to see its edge.
  camera_.target[0] = std::clamp(camera_.target[0], -0.5 * land.east, 1.5 * land.east);
  camera_.target[1] = std::clamp(camera_.target[1], -0.5 * land.north, 1.5 * land.north);
  camera_.target[2] = std::clamp(camera_.target[2], land.low - side, land.high + side);
}

}  // namespace erg::ui
