// What must hold for pictures whatever they look like.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/errors.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene.h"

namespace erg::test {

using picture::Camera;
using picture::Colour;
using picture::find_palette;
using picture::RgbImage;
using render::camera_preset;
using render::Look;
using render::Picture;
using render::Renderer;
using render::RenderQuality;
using render::TerrainView;

namespace {

constexpr Colour magenta{1, 0, 0xee / 255.0f};

class Pictures : public testing::Test {
 protected:
  // A top view of the terrain in which a cell is `zoom` pixels wide.
  Picture top_view(const TerrainView& view, const Look& look, int zoom = 2) {
    const Camera camera = camera_preset("top", Renderer::box_of(view, look), 1);
    return renderer_.draw(view, look, camera, {zoom * view.terrain->nx(), zoom * view.terrain->ny(), 1});
  }

  static Look values(const std::string& show, const std::string& palette = "") {
    Look look;
    look.show = show;
    look.palette = palette;
    look.shading = false;
    look.legend = false;
    return look;
  }

  std::unique_ptr<render::GlContext> context_ = render::make_offscreen_context(usual_context());
  Renderer renderer_;
};

// A quarter turn anticlockwise: what lay in the east lies in the north.
Terrain turned(const Terrain& terrain) {
  Terrain result({terrain.ny(), terrain.nx()}, terrain.cell_size(), terrain.quantum(), terrain.boundary());
  const auto turn = [&](const auto& from, auto& to) {
    for (int y = 0; y < terrain.ny(); ++y) {
      for (int x = 0; x < terrain.nx(); ++x) to(terrain.ny() - 1 - y, x) = from(x, y);
    }
  };
  turn(terrain.bedrock(), result.edit_bedrock());
  turn(terrain.mobile(), result.edit_mobile());
  result.edit_fields() = terrain.fields();
  for (std::size_t field = 0; field < terrain.fields().size(); ++field) {
    turn(terrain.fields()[field].values, result.edit_fields()[field].values);
  }
  return result;
}

TEST_F(Pictures, SceneAndCameraTurnedTogetherGiveTheSamePicture) {
  const Terrain terrain = landscape();
  const Terrain quarter = turned(terrain);
  for (const std::string show : {"material", "elevation", "slope"}) {
    Look look;
    look.show = show;
    look.grain = 0;
    look.tufts = false;  // they stand where chance puts them
    look.legend = false;
    TerrainView view = view_of(terrain);
    Camera camera = camera_preset("oblique", Renderer::box_of(view, look), 4.0 / 3);
    const RgbImage before = renderer_.draw(view, look, camera, {160, 120, 2}).opaque();
    const double none_turned = difference(before, RgbImage(160, 120, {0.5f, 0.5f, 0.5f})).mean;

    camera.bearing -= 90;
    look.sun_bearing -= 90;
    view.terrain = &quarter;
    view.wind = 180;
    const Difference apart = difference(before, renderer_.draw(view, look, camera, {160, 120, 2}).opaque());
    EXPECT_LT(apart.mean, 0.5) << show;
    EXPECT_LT(apart.largest, 12) << show;
    EXPECT_GT(none_turned, 10) << "the picture shows something";
  }
}

TEST_F(Pictures, ContoursLieAtTheirHeights) {
  // A ramp of one slab a cell to the east: the height in m at the middle of cell x is x / 3.
  Terrain ramp({side, side}, 1.0, slab, Boundary::open);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) ramp.edit_mobile()(x, y) = x;
  }
  Look look = values("elevation", "sand");
  constexpr int zoom = 4;
  const Picture plain = top_view(view_of(ramp), look, zoom);
  look.contours = 4;
  const Picture lined = top_view(view_of(ramp), look, zoom);
  const RgbImage before = plain.opaque(), after = lined.opaque();
  std::vector<double> lines;
  const int row = zoom * side / 2;
  const auto darker = [&](int x) { return before.pixel(x, row)[1] - after.pixel(x, row)[1]; };
  for (int x = 1; x + 1 < after.width; ++x) {
    if (darker(x) > 8 && darker(x) >= darker(x - 1) && darker(x) > darker(x + 1)) {
      lines.push_back(((x + 0.5) / zoom - 0.5) * slab);
    }
  }
  ASSERT_EQ(lines.size(), 7u) << "at 4, 8 ... 28 m; the ground ends at 31.7 m";
  for (std::size_t line = 0; line < lines.size(); ++line) {
    EXPECT_NEAR(lines[line], 4.0 * (static_cast<double>(line) + 1), 1.0 / zoom) << "a pixel is 0.08 m of height";
  }
}

TEST_F(Pictures, LegendEndsAreTheDataEnds) {
  Terrain terrain = landscape();
  Grid<float>& age = terrain.edit_fields()[1].values;
  age(3, 4) = -17.5f;
  age(90, 80) = 412.25f;
  age(1, 1) = std::numeric_limits<float>::quiet_NaN();
  const Picture picture = top_view(view_of(terrain), values("age"));
  ASSERT_TRUE(picture.scale.has_value());
  EXPECT_EQ(picture.scale->low, -17.5);
  EXPECT_EQ(picture.scale->high, 412.25);
  EXPECT_EQ(picture.scale->unit, "steps");
  const Picture heights = top_view(view_of(terrain), values("elevation"));
  EXPECT_EQ(heights.scale->low, 0);
  EXPECT_NEAR(heights.scale->high, 36 * slab, 1e-12) << "the rock";
  EXPECT_EQ(heights.scale->unit, "m");
}

TEST_F(Pictures, ColoursAreThoseOfThePalette) {
  // West half 0, east half 10, in a field: the two ends of the palette.
  Terrain terrain({side, side}, 1.0, slab);
  Grid<float> halves({side, side});
  for (int y = 0; y < side; ++y) {
    for (int x = side / 2; x < side; ++x) halves(x, y) = 10;
  }
  terrain.edit_fields() = {{{"half", "half", "m", 0, 10, "cividis", ""}, halves}};
  const RgbImage image = top_view(view_of(terrain), values("half")).opaque();
  const auto expect_colour = [&](int x, Colour colour) {
    const std::uint8_t* pixel = image.pixel(x, image.height / 2);
    EXPECT_NEAR(pixel[0], 255 * colour.red, 2);
    EXPECT_NEAR(pixel[1], 255 * colour.green, 2);
    EXPECT_NEAR(pixel[2], 255 * colour.blue, 2);
  };
  expect_colour(image.width / 4, find_palette("cividis").points.front());
  expect_colour(3 * image.width / 4, find_palette("cividis").points.back());
}

TEST_F(Pictures, OnlyChangedTilesAreUploaded) {
  Terrain terrain({200, 130}, 1.0, slab);  // tiles of 64: four by three, the last ones narrower
  const Look look = values("elevation");
  auto uploaded = [&, last = std::int64_t{0}]() mutable {
    top_view(view_of(terrain), look, 1);
    const std::int64_t now = renderer_.uploaded_texels();
    return now - std::exchange(last, now);
  };
  EXPECT_EQ(uploaded(), 200 * 130) << "all of it at first";
  EXPECT_EQ(uploaded(), 0) << "nothing changed";
  terrain.edit_mobile()(70, 10) += 1;
  EXPECT_EQ(uploaded(), 64 * 64) << "one tile";
  terrain.edit_mobile()(0, 0) += 1;
  terrain.edit_mobile()(63, 63) += 1;
  terrain.edit_mobile()(199, 129) += 1;
  EXPECT_EQ(uploaded(), 64 * 64 + 8 * 2) << "a whole tile and the last corner, 200 - 192 by 130 - 128";
  terrain.edit_mobile()(0, 0) += 0;
  EXPECT_EQ(uploaded(), 0) << "asked for, not changed";
}

TEST_F(Pictures, ValuesThatAreNoNumbersAreMagentaAndNoted) {
  Terrain terrain = landscape();
  for (int y = 40; y < 60; ++y) {
    for (int x = 20; x < 40; ++x) terrain.edit_fields()[1].values(x, y) = std::numeric_limits<float>::quiet_NaN();
  }
  const Picture picture = top_view(view_of(terrain), values("age"), 1);
  ASSERT_EQ(picture.notes.size(), 1u);
  EXPECT_NE(picture.notes[0].find("\"age\" has 400 values"), std::string::npos) << picture.notes[0];
  const RgbImage image = picture.opaque();
  int drawn = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* pixel = image.pixel(x, y);
      drawn += pixel[0] > 240 && pixel[1] < 20 && pixel[2] > 220;
    }
  }
  EXPECT_EQ(drawn, 400);
}

TEST_F(Pictures, AnEmptyFieldAndAnEmptyTerrainAreDrawnInMagenta) {
  Terrain terrain = landscape();
  terrain.edit_fields()[1].values = {};
  const Picture field = top_view(view_of(terrain), values("age"));
  ASSERT_EQ(field.notes.size(), 1u);
  EXPECT_NE(field.notes[0].find("\"age\" is empty"), std::string::npos);
  EXPECT_LT(difference(field.opaque(), RgbImage(field.image.width, field.image.height, magenta)).largest, 25);

  const Terrain nothing;
  const Picture blank = renderer_.draw(view_of(nothing), Look{}, Camera{}, {40, 30, 1});
  ASSERT_EQ(blank.notes.size(), 1u);
  EXPECT_EQ(difference(blank.opaque(), RgbImage(40, 30, magenta)).largest, 0);
}

// The slope along the wind, as the picture shows it: degrees in the middle of each pixel of one row.
std::vector<double> slope_profile(const RgbImage& image) {
  std::vector<double> slopes;
  for (int x = 0; x < image.width; ++x) slopes.push_back(image.pixel(x, image.height / 2)[0] / 255.0 * 45);
  return slopes;
}

TEST_F(Pictures, SlabsAreNoTerracesAndTheBrinkStaysCrisp) {
  const Terrain terrain = ridges();
  constexpr int zoom = 4;
  const std::vector<double> slopes = slope_profile(top_view(view_of(terrain), values("slope", "grey"), zoom).opaque());
  // Cell 4 to 30 is the windward slope: 24 slabs over 36 cells, 12.5 degrees.
  double mean = 0, square = 0;
  int count = 0;
  for (int x = 4 * zoom; x < 30 * zoom; ++x, ++count) mean += slopes[x], square += slopes[x] * slopes[x];
  mean /= count;
  EXPECT_NEAR(mean, 12.5, 2);
  EXPECT_LT(std::sqrt(square / count - mean * mean), 4) << "single slabs make slopes of 0 to 45 degrees";
  EXPECT_NEAR(slopes[42 * zoom], 33.7, 2) << "the slip face";
  // From windward slope to slip face within three cells, at the brink.
  int last_gentle = 0, first_steep = 0;
  for (int x = 30 * zoom; x < 42 * zoom; ++x) {
    if (slopes[x] < 18) last_gentle = x;
    if (first_steep == 0 && slopes[x] > 28) first_steep = x;
  }
  EXPECT_LE(first_steep - last_gentle, 3 * zoom);
  EXPECT_NEAR(static_cast<double>(first_steep) / zoom - 0.5, brink, 2.0);
}

TEST_F(Pictures, TilesOfDifferentDetailLeaveNoGaps) {
  const Terrain terrain = landscape();
  Look look;
  look.copies = 3;
  look.transparent = true;
  Camera camera{.target = {48, 48, 2}, .bearing = 200, .altitude = 35, .distance = 90, .opening = 40};
  const Picture picture = renderer_.draw(view_of(terrain), look, camera, {240, 180, 1});
  int holes = 0;
  for (std::size_t at = 3; at < picture.image.pixels.size(); at += 4) holes += picture.image.pixels[at] != 255;
  EXPECT_EQ(holes, 0);
}

TEST_F(Pictures, FarTerrainHasFewerTriangles) {
  const Terrain terrain = landscape();
  Look look;
  Camera camera{.target = {48, 48, 2}, .bearing = 180, .altitude = 40, .distance = 120};
  const std::int64_t near = renderer_.draw(view_of(terrain), look, camera, {160, 120, 1}).triangles;
  camera.distance = 1200;
  const std::int64_t far = renderer_.draw(view_of(terrain), look, camera, {160, 120, 1}).triangles;
  EXPECT_GT(near, 10 * far);
  EXPECT_GT(far, 0);
}

TEST_F(Pictures, LargeGridsAreDrawnInBlocksInAHurry) {
  const Terrain terrain({300, 200}, 1.0, slab);
  RenderQuality quality;
  quality.largest_side = 128;
  quality.tiled = false;
  renderer_.set_quality(quality);
  const Picture picture = top_view(view_of(terrain), values("elevation"), 1);
  ASSERT_EQ(picture.notes.size(), 1u);
  EXPECT_NE(picture.notes[0].find("3 x 3"), std::string::npos) << picture.notes[0];
  EXPECT_EQ(renderer_.uploaded_texels(), 100 * 67);
}

// Four ridges side by side.
Terrain long_terrain() {
  const Terrain part = ridges();
  Terrain terrain({2 * side, 64}, 1.0, slab);
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) terrain.edit_mobile()(x, y) = part.mobile()(x % side, y);
  }
  return terrain;
}

TEST_F(Pictures, ATerrainLargerThanATextureIsCutIntoSheetsThatDoNotShow) {
  const Terrain terrain = long_terrain();
  Look look;
  look.legend = false;
  RenderQuality quality;
  quality.largest_map = 2 * side;  // one texel a cell, cut or not
  for (const std::string camera : {"top", "block"}) {
    const auto draw = [&](int largest_side) {
      quality.largest_side = largest_side;
      renderer_.set_quality(quality);
      const Camera stands = camera_preset(camera, Renderer::box_of(view_of(terrain), look), 2);
      return renderer_.draw(view_of(terrain), look, stands, {384, 192, 1}).opaque();
    };
    const RgbImage whole = draw(2 * side);
    const std::int64_t before = renderer_.uploaded_texels();
    const RgbImage cut = draw(128);
    // Three sheets of 64 cells, each with 20 more on every side.
    EXPECT_EQ(renderer_.uploaded_texels() - before, 3 * 104 * 104) << camera;
    const Difference apart = difference(whole, cut);
    EXPECT_LT(apart.mean, 0.3) << camera;
    EXPECT_LT(apart.largest, 12) << camera;
  }
}

TEST_F(Pictures, FarSheetsAreCoarser) {
  const Terrain terrain = long_terrain();
  RenderQuality quality;
  quality.largest_side = 128;
  renderer_.set_quality(quality);
  const Look look;
  Camera camera{.target = {10, 32, 2}, .bearing = 270, .altitude = 30, .distance = 40};
  renderer_.draw(view_of(terrain), look, camera, {64, 48, 1});
  const std::int64_t near = renderer_.uploaded_texels();
  EXPECT_LT(near, 3 * 104 * 104) << "the last sheet is 120 m away, where a pixel is larger than two cells";
  camera.distance = 1000;
  renderer_.draw(view_of(terrain), look, camera, {64, 48, 1});
  EXPECT_LT(renderer_.uploaded_texels() - near, near / 2);
}

TEST_F(Pictures, WhatChangesInATileIsComputedThereAndLooksLikeAllComputedAnew) {
  Terrain terrain({320, 320}, 1.0, slab);
  for (int y = 0; y < 320; ++y) {
    for (int x = 0; x < 320; ++x) terrain.edit_mobile()(x, y) = 6 + static_cast<int>(mix64(x + 320 * y) % 3);
  }
  RenderQuality quality;
  quality.largest_map = 320;
  quality.sky_steps = 6;
  Look look;
  look.legend = false;
  const auto draw = [&](Renderer& renderer) {
    renderer.set_quality(quality);
    const Camera camera = camera_preset("top", Renderer::box_of(view_of(terrain), look), 1);
    return renderer.draw(view_of(terrain), look, camera, {320, 320, 1}).opaque();
  };
  terrain.edit_mobile()(100, 100) = 20;  // so that the highest point stays
  draw(renderer_);
  const std::int64_t all = renderer_.computed_texels();
  EXPECT_EQ(all, 320 * 320);
  for (const auto& [x, y] : {std::pair{75, 70}, std::pair{319, 0}}) {
    for (int step = 0; step < 9; ++step) terrain.edit_mobile()(x - step, y) = 20;
    const RgbImage updated = draw(renderer_);
    Renderer fresh;
    EXPECT_EQ(difference(updated, draw(fresh)).largest, 0) << x << " " << y;
  }
  // A tile of 64 cells and the 18 around it that smoothing reaches, twice.
  EXPECT_EQ(renderer_.computed_texels() - all, 2 * 100 * 100);
}

TEST_F(Pictures, TransparentPicturesHaveNothingBehindTheTerrain) {
  const Terrain terrain = landscape();
  Look look;
  look.transparent = true;
  const TerrainView view = view_of(terrain);
  const Picture picture =
      renderer_.draw(view, look, camera_preset("side", Renderer::box_of(view, look), 2), {160, 80, 2});
  EXPECT_EQ(picture.image.pixels[3], 0) << "upper left corner";
  EXPECT_EQ(picture.image.pixels[4 * (40 * 160 + 80) + 3], 255) << "middle";
}

TEST_F(Pictures, ACameraBelowTheGroundIsLifted) {
  const Terrain terrain = landscape();
  Look look;
  look.copies = 1;
  look.legend = false;
  const Camera below{.target = {60, 48, -30}, .bearing = 180, .altitude = 0, .distance = 30, .opening = 40};
  const RgbImage image = renderer_.draw(view_of(terrain), look, below, {160, 120, 1}).opaque();
  // From under the ground there would be no sky; from above it the upper rim is sky, which is bluer than sand.
  EXPECT_GT(image.pixel(80, 2)[2], image.pixel(80, 117)[2]);
}

TEST_F(Pictures, TheScaleBarStandsInTopViewsOnly) {
  const Terrain terrain = landscape();
  TerrainView view = view_of(terrain);
  view.wind.reset();
  const auto writing = [&](const std::string& preset) {
    Look look;
    const Camera camera = camera_preset(preset, Renderer::box_of(view, look), 1);
    const RgbImage with = renderer_.draw(view, look, camera, {240, 240, 1}).opaque();
    look.legend = false;
    return difference(with, renderer_.draw(view, look, camera, {240, 240, 1}).opaque()).largest;
  };
  EXPECT_GT(writing("top"), 20);
  EXPECT_EQ(writing("oblique"), 0);
}

TEST_F(Pictures, WrongLooksAreRefusedWithTheNearestWord) {
  const Terrain terrain = landscape();
  const auto message = [&](const Look& look) -> std::string {
    try {
      renderer_.draw(view_of(terrain), look, Camera{}, {16, 16, 1});
    } catch (const InputError& error) {
      return error.mistakes().front().text();
    }
    return "nothing";
  };
  EXPECT_NE(message(values("vegetatoin")).find("did you mean \"vegetation\""), std::string::npos);
  EXPECT_NE(message(values("elevation", "cividas")).find("did you mean \"cividis\""), std::string::npos);
  Look night;
  night.sun_altitude = -5;
  EXPECT_NE(message(night).find("sun altitude"), std::string::npos);
  EXPECT_THROW(renderer_.draw(view_of(terrain), Look{}, Camera{}, {0, 10, 1}), InputError);
  EXPECT_THROW(renderer_.draw(view_of(terrain), Look{}, Camera{}, {10, 10, 9}), InputError);
}

}  // namespace
}  // namespace erg::test
