// The camera's movements and matrices.
#pragma once

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "picture/camera.h"

namespace erg::render {

/// The block of terrain that a picture shows, in m.
struct TerrainBox {
  double east = 1;   ///< extent from west to east
  double north = 1;  ///< extent from south to north
  double low = 0;    ///< height of the lowest point
  double high = 1;   ///< height of the highest point

  /// Its centre, m.
  Eigen::Vector3d middle() const { return {0.5 * east, 0.5 * north, 0.5 * (low + high)}; }
};

/// "top" (orthographic, north up), "oblique" (over the terrain towards the horizon), "block" (the whole of it from the
/// south), "side".
const std::vector<std::string>& camera_presets();

/// The preset of this name for a picture of this shape (width / height). Throws InputError with the nearest name.
picture::Camera camera_preset(std::string_view name, const TerrainBox& box, double aspect);

/// Where the camera stands, m.
Eigen::Vector3d eye(const picture::Camera& camera);

/// From the terrain to the camera, and from there to the picture (OpenGL's clip space). `reach`: how far from the
/// target things are drawn, m.
Eigen::Matrix4d view_matrix(const picture::Camera& camera);
Eigen::Matrix4d projection_matrix(const picture::Camera& camera, double aspect, double reach);

/// A place in the picture: x from -1 (left) to 1 (right), y from -1 (below) to 1 (above).
struct PicturePoint {
  double x = 0;
  double y = 0;
};

/// The line of sight through a place of the picture.
struct Sight {
  Eigen::Vector3d from;
  Eigen::Vector3d direction;  ///< of length 1
};
Sight sight(const picture::Camera& camera, PicturePoint point, double aspect);

/// Turns around the target; the altitude stays within -89 to 90 degrees.
void orbit(picture::Camera& camera, double bearing, double altitude);

/// Moves the target within the picture plane, by shares of the picture's height to the right and upwards.
void pan(picture::Camera& camera, double right, double up);

/// Comes nearer (factor below 1) or goes away so that the terrain point under the cursor stays under it. `under_cursor`
/// in m.
void zoom(picture::Camera& camera, double factor, const Eigen::Vector3d& under_cursor);

/// Moves eye and target together: m forwards along the view, to the right and upwards.
void fly(picture::Camera& camera, double forwards, double right, double up);

/// Turns the view about the eye.
void look_around(picture::Camera& camera, double bearing, double altitude);

/// The height of the terrain at (east, north), m.
using GroundHeight = std::function<double(double east, double north)>;

/// Lifts a camera that is less than `clearance` (m) above the ground.
void keep_above(picture::Camera& camera, const GroundHeight& ground, double clearance);

}  // namespace erg::render
