#include "render/camera.h"

#include <algorithm>
#include <cmath>

#include "core/errors.h"
#include "core/units.h"

namespace erg::render {

using picture::Camera;

namespace {

constexpr double lowest_altitude = -89;
constexpr double highest_altitude = 90;

Eigen::Vector3d as_vector(const std::array<double, 3>& point) { return {point[0], point[1], point[2]}; }
void set_target(Camera& camera, const Eigen::Vector3d& point) { camera.target = {point.x(), point.y(), point.z()}; }

// The camera's own axes in the terrain: to the right, upwards, and back from the target to the eye.
struct Axes {
  Eigen::Vector3d right, up, back;
};

Axes axes(const Camera& camera) {
  const double turn = radians(camera.bearing);
  const double rise = radians(camera.altitude);
  const Eigen::Vector3d outwards(std::sin(turn), std::cos(turn), 0);
  const Eigen::Vector3d right(-outwards.y(), outwards.x(), 0);
  const Eigen::Vector3d back = std::cos(rise) * outwards + std::sin(rise) * Eigen::Vector3d::UnitZ();
  return {right, back.cross(right), back};
}

double half_height(const Camera& camera) { return camera.distance * std::tan(radians(0.5 * camera.opening)); }

// The distance from which a length (m) fills the share `part` of the picture's height.
double distance_for(double length, double part, double opening) {
  return 0.5 * length / part / std::tan(radians(0.5 * opening));
}

}  // namespace

const std::vector<std::string>& camera_presets() {
  static const std::vector<std::string> names{"top", "oblique", "block", "side"};
  return names;
}

Camera camera_preset(std::string_view name, const TerrainBox& box, double aspect) {
  Camera camera;
  set_target(camera, box.middle());
  if (name == "top") {
    camera.orthographic = true;
    camera.distance = distance_for(std::max(box.north, box.east / aspect), 1, camera.opening);
    camera.distance = std::max(camera.distance, box.high - box.low);
  } else if (name == "oblique") {
    camera.bearing = 160;
    camera.altitude = 13;
    camera.opening = 36;
    camera.distance = distance_for(std::max(0.75 * box.north, box.east / aspect), 1.3, camera.opening);
  } else if (name == "block") {
    camera.bearing = 155;
    camera.altitude = 30;
    camera.opening = 26;
    camera.distance = distance_for(std::max(0.9 * box.north, 1.35 * box.east / aspect), 0.83, camera.opening);
  } else if (name == "side") {
    camera.bearing = 180;
    camera.altitude = 8;
    camera.opening = 20;
    camera.distance = distance_for(box.east / aspect, 0.95, camera.opening) + 0.5 * box.north;
  } else {
    throw InputError("camera", "there is no view " + quote(name), suggestion(name, camera_presets()));
  }
  return camera;
}

Eigen::Vector3d eye(const Camera& camera) { return as_vector(camera.target) + camera.distance * axes(camera).back; }

Eigen::Matrix4d view_matrix(const Camera& camera) {
  const Axes own = axes(camera);
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.block<1, 3>(0, 0) = own.right.transpose();
  view.block<1, 3>(1, 0) = own.up.transpose();
  view.block<1, 3>(2, 0) = own.back.transpose();
  view.block<3, 1>(0, 3) = -(view.block<3, 3>(0, 0) * eye(camera));
  return view;
}

Eigen::Matrix4d projection_matrix(const Camera& camera, double aspect, double reach) {
  Eigen::Matrix4d projection = Eigen::Matrix4d::Zero();
  if (camera.orthographic) {
    const double high = half_height(camera);
    const double far = camera.distance + reach;
    const double near = camera.distance - reach;
    projection(0, 0) = 1 / (high * aspect);
    projection(1, 1) = 1 / high;
    projection(2, 2) = -2 / (far - near);
    projection(2, 3) = -(far + near) / (far - near);
    projection(3, 3) = 1;
    return projection;
  }
  const double scale = 1 / std::tan(radians(0.5 * camera.opening));
  const double far = camera.distance + reach;
  const double near = std::max(camera.distance / 200, far / 20000);
  projection(0, 0) = scale / aspect;
  projection(1, 1) = scale;
  projection(2, 2) = -(far + near) / (far - near);
  projection(2, 3) = -2 * far * near / (far - near);
  projection(3, 2) = -1;
  return projection;
}

Sight sight(const Camera& camera, PicturePoint point, double aspect) {
  const Axes own = axes(camera);
  const double half = std::tan(radians(0.5 * camera.opening));
  const Eigen::Vector3d aside = half * (point.x * aspect * own.right + point.y * own.up);
  if (camera.orthographic) return {eye(camera) + camera.distance * aside, -own.back};
  return {eye(camera), (aside - own.back).normalized()};
}

void orbit(Camera& camera, double bearing, double altitude) {
  camera.bearing = fold_bearing(camera.bearing + bearing);
  camera.altitude = std::clamp(camera.altitude + altitude, lowest_altitude, highest_altitude);
}

void pan(Camera& camera, double right, double up) {
  const Axes own = axes(camera);
  const double height = 2 * half_height(camera);
  set_target(camera, as_vector(camera.target) + height * (right * own.right + up * own.up));
}

void zoom(Camera& camera, double factor, const Eigen::Vector3d& under_cursor) {
  // The eye and the target both move along straight lines to the point, so its line of sight stays.
  camera.distance *= factor;
  set_target(camera, under_cursor + factor * (as_vector(camera.target) - under_cursor));
}

void fly(Camera& camera, double forwards, double right, double up) {
  const Axes own = axes(camera);
  set_target(camera,
             as_vector(camera.target) - forwards * own.back + right * own.right + up * Eigen::Vector3d::UnitZ());
}

void look_around(Camera& camera, double bearing, double altitude) {
  const Eigen::Vector3d stands = eye(camera);
  orbit(camera, bearing, altitude);
  set_target(camera, stands - camera.distance * axes(camera).back);
}

void keep_above(Camera& camera, const GroundHeight& ground, double clearance) {
  const Eigen::Vector3d stands = eye(camera);
  const double missing = ground(stands.x(), stands.y()) + clearance - stands.z();
  if (missing > 0) camera.target[2] += missing;
}

}  // namespace erg::render
