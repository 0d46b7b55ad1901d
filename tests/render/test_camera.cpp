// The camera's movements.
#include "render/camera.h"

#include <gtest/gtest.h>

#include "core/errors.h"

namespace erg::test {

using picture::Camera;
using render::camera_preset;
using render::camera_presets;
using render::eye;
using render::keep_above;
using render::orbit;
using render::PicturePoint;

namespace {

const render::TerrainBox box{400, 300, 0, 12};

// Where a terrain point appears in the picture.
PicturePoint seen(const Camera& camera, const Eigen::Vector3d& point, double aspect = 1.5) {
  const Eigen::Vector4d clip =
      render::projection_matrix(camera, aspect, 1000) * render::view_matrix(camera) * point.homogeneous();
  return {clip.x() / clip.w(), clip.y() / clip.w()};
}

TEST(Camera, PresetsLookAtTheMiddle) {
  for (const std::string& name : camera_presets()) {
    const PicturePoint middle = seen(camera_preset(name, box, 1.5), box.middle());
    EXPECT_NEAR(middle.x, 0, 1e-12) << name;
    EXPECT_NEAR(middle.y, 0, 1e-12) << name;
  }
  EXPECT_THROW(camera_preset("obligue", box, 1.5), InputError);
}

TEST(Camera, TopViewHasNorthUpAndEastRight) {
  const Camera top = camera_preset("top", box, 4.0 / 3);
  const PicturePoint corner = seen(top, {400, 300, 6}, 4.0 / 3);
  EXPECT_NEAR(corner.x, 1, 1e-9) << "the terrain fills the picture";
  EXPECT_NEAR(corner.y, 1, 1e-9);
}

TEST(Camera, StandsWhereItsBearingSays) {
  const Camera camera{.target = {10, 20, 3}, .bearing = 90, .altitude = 30, .distance = 2};
  const Eigen::Vector3d stands = eye(camera);
  EXPECT_NEAR(stands.x(), 10 + 2 * std::cos(M_PI / 6), 1e-12) << "in the east";
  EXPECT_NEAR(stands.y(), 20, 1e-12);
  EXPECT_NEAR(stands.z(), 3 + 1, 1e-12);
}

TEST(Camera, SightMeetsWhatIsSeenThere) {
  for (const std::string& name : camera_presets()) {
    const Camera camera = camera_preset(name, box, 1.5);
    const PicturePoint point{0.4, -0.3};
    const render::Sight line = render::sight(camera, point, 1.5);
    const PicturePoint back = seen(camera, line.from + 1.1 * camera.distance * line.direction);
    EXPECT_NEAR(back.x, point.x, 1e-9) << name;
    EXPECT_NEAR(back.y, point.y, 1e-9) << name;
  }
}

TEST(Camera, ZoomKeepsThePointUnderTheCursor) {
  for (const std::string& name : camera_presets()) {
    Camera camera = camera_preset(name, box, 1.5);
    const Eigen::Vector3d point(120, 200, 5);
    const PicturePoint before = seen(camera, point);
    const double distance = camera.distance;
    render::zoom(camera, 0.5, point);
    EXPECT_DOUBLE_EQ(camera.distance, 0.5 * distance);
    EXPECT_NEAR(seen(camera, point).x, before.x, 1e-9) << name;
    EXPECT_NEAR(seen(camera, point).y, before.y, 1e-9) << name;
  }
}

TEST(Camera, OrbitKeepsTargetAndDistanceAndStopsAtThePoles) {
  Camera camera = camera_preset("oblique", box, 1.5);
  const Camera before = camera;
  orbit(camera, -500, 20);
  EXPECT_EQ(camera.target, before.target);
  EXPECT_EQ(camera.distance, before.distance);
  EXPECT_GE(camera.bearing, 0);
  EXPECT_LT(camera.bearing, 360);
  orbit(camera, 0, 500);
  EXPECT_EQ(camera.altitude, 90);
  orbit(camera, 0, -500);
  EXPECT_EQ(camera.altitude, -89);
}

TEST(Camera, PanMovesByTheShareOfThePicture) {
  Camera camera = camera_preset("top", box, 1.5);
  const Eigen::Vector3d point = box.middle();
  render::pan(camera, 0.1, 0.2);
  const PicturePoint after = seen(camera, point);
  EXPECT_NEAR(after.y, -2 * 0.2, 1e-9) << "the picture is 2 high";
  EXPECT_NEAR(after.x, -2 * 0.1 / 1.5, 1e-9);
}

TEST(Camera, FlyingMovesTheEyeAlongTheView) {
  Camera camera = camera_preset("oblique", box, 1.5);
  const Eigen::Vector3d before = eye(camera);
  render::fly(camera, 30, 0, 0);
  EXPECT_NEAR((eye(camera) - before).norm(), 30, 1e-9);
  EXPECT_NEAR((eye(camera) - before).dot((box.middle() - before).normalized()), 30, 1e-9);
  const Eigen::Vector3d stands = eye(camera);
  render::look_around(camera, 25, -3);
  EXPECT_NEAR((eye(camera) - stands).norm(), 0, 1e-9) << "looking round moves nothing";
}

TEST(Camera, IsNeverUnderTheGround) {
  const render::GroundHeight hill = [](double east, double) { return 0.1 * east; };
  for (double altitude = -60; altitude <= 90; altitude += 15) {
    Camera camera{.target = {200, 150, 0}, .bearing = 90, .altitude = altitude, .distance = 100};
    keep_above(camera, hill, 2);
    const Eigen::Vector3d stands = eye(camera);
    EXPECT_GE(stands.z(), 0.1 * stands.x() + 2 - 1e-9) << altitude;
  }
  Camera high{.target = {200, 150, 0}, .bearing = 90, .altitude = 60, .distance = 100};
  const Camera before = high;
  keep_above(high, hill, 2);
  EXPECT_EQ(high, before) << "a camera above the ground stays";
}

}  // namespace
}  // namespace erg::test
