// The camera in a person's hand.
#include <gtest/gtest.h>

#include "flat_host.h"

namespace erg::test {

using render::eye;
using ui::TerrainCamera;

namespace {

constexpr double aspect = 1.5;
const FlatGround ground{{200, 100, 0, 10}};

TerrainCamera block() {
  TerrainCamera camera;
  camera.choose("block", ground.box(), aspect);
  return camera;
}

TEST(TerrainCamera, TheWheelKeepsWhatIsUnderThePointerUnderIt) {
  TerrainCamera camera = block();
  const render::PicturePoint cursor{0.2, -0.1};
  const auto before = ground.under(camera.camera(), cursor, aspect);
  ASSERT_TRUE(before);
  EXPECT_TRUE(camera.move({.cursor = cursor, .wheel = 3}, ground, aspect));
  const auto after = ground.under(camera.camera(), cursor, aspect);
  ASSERT_TRUE(after);
  EXPECT_LT((*after - *before).norm(), 1e-6);
}

TEST(TerrainCamera, ItNeverGoesUnderTheGround) {
  TerrainCamera camera = block();
  for (int i = 0; i < 50; ++i) camera.move({.orbit = true, .up = 0.1}, ground, aspect);
  EXPECT_GT(eye(camera.camera()).z(), 0.5);
  for (int i = 0; i < 200; ++i) camera.move({.rise = -1, .seconds = 0.1}, ground, aspect);
  EXPECT_GT(eye(camera.camera()).z(), 0.5);
}

TEST(TerrainCamera, ItStaysWithinReachOfTheTerrain) {
  TerrainCamera camera = block();
  for (int i = 0; i < 200; ++i) camera.move({.wheel = -5}, ground, aspect);
  EXPECT_LE(camera.camera().distance, 20 * 200);
  for (int i = 0; i < 200; ++i) camera.move({.pan = true, .right = 1}, ground, aspect);
  EXPECT_GE(camera.camera().target[0], -100);
}

TEST(TerrainCamera, FrameKeepsTheDirectionAndShowsAllCorners) {
  TerrainCamera camera = block();
  camera.move({.orbit = true, .right = 0.2}, ground, aspect);
  camera.move({.wheel = 8}, ground, aspect);
  const double bearing = camera.camera().bearing;
  camera.choose("frame", ground.box(), aspect);
  EXPECT_EQ(camera.camera().bearing, bearing);
  const ui::WindowPart part{0, 0, 900, 600};
  for (const double east : {0.0, 200.0}) {
    for (const double north : {0.0, 100.0}) {
      const auto seen = ui::to_window({east, north, 0}, camera.camera(), part);
      ASSERT_TRUE(seen);
      EXPECT_GE(seen->x, 0);
      EXPECT_LE(seen->x, 900);
      EXPECT_GE(seen->y, 0);
      EXPECT_LE(seen->y, 600);
    }
  }
}

TEST(TerrainCamera, NothingMovesWithoutAHand) {
  TerrainCamera camera = block();
  EXPECT_FALSE(camera.move({}, ground, aspect));
}

}  // namespace
}  // namespace erg::test
