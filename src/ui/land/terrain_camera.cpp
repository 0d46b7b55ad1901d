#include "ui/land/terrain_camera.h"

#include <algorithm>
#include <cmath>

#include "core/units.h"

namespace erg::ui {

using render::fly;
using render::pan;
using render::TerrainBox;

namespace {

constexpr double degrees_per_height = 180;  // a drag over the whole picture turns the camera half round
constexpr double zoom_per_click = 0.85;
constexpr double flight = 0.5;      // of the distance to the target, each second
constexpr double clearance = 0.01;  // of the terrain's shorter side, above the ground
constexpr double farthest = 20;     // times the terrain's longer side
constexpr double nearest = 1e-3;

}  // namespace

void TerrainCamera::choose(const std::string& preset, const TerrainBox& box, double aspect) {
  if (preset != "frame") {
    camera_ = render::camera_preset(preset, box, aspect);
    return;
  }
  const Eigen::Vector3d middle = box.middle();
  camera_.target = {middle.x(), middle.y(), middle.z()};
  const double across = std::hypot(box.east, box.north) / std::min(1.0, aspect);
  camera_.distance = 0.5 * across / std::tan(radians(0.5 * camera_.opening));
}

bool TerrainCamera::move(const CameraInput& input, const TerrainGround& ground, double aspect) {
  const picture::Camera before = camera_;
  const TerrainBox box = ground.box();
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
  stay_near(box);
  const double keep = clearance * std::min(box.east, box.north);
  if (!camera_.orthographic) {
    render::keep_above(
        camera_, [&](double east, double north) { return ground.height(east, north); }, keep);
  }
  return camera_ != before;
}

void TerrainCamera::stay_near(const TerrainBox& box) {
  const double side = std::max(box.east, box.north);
  camera_.distance = std::clamp(camera_.distance, nearest * side, farthest * side);
  // Where the target lies outside, half a terrain's width away is far enough to see its edge.
  camera_.target[0] = std::clamp(camera_.target[0], -0.5 * box.east, 1.5 * box.east);
  camera_.target[1] = std::clamp(camera_.target[1], -0.5 * box.north, 1.5 * box.north);
  camera_.target[2] = std::clamp(camera_.target[2], box.low - side, box.high + side);
}

}  // namespace erg::ui
