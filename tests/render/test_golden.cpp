// Every look, drawn by both off-screen contexts, beside a picture that was looked at and found good. With
// ERG_UPDATE_GOLDEN set, the pictures are written anew instead: look at them before they are kept.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>

#include "compute/executor.h"
#include "io/formats/png.h"
#include "kernels/shadow.h"
#include "models/model.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene.h"
#include "sim/flux_watch.h"
#include "sim/make_executor.h"

namespace erg::test {

using picture::RgbImage;
using render::has_osmesa;
using render::Look;
using render::make_offscreen_context;
using render::Renderer;

namespace {

struct Shot {
  std::string name;
  std::string camera;
  std::function<void(Look&)> change;
};

const std::vector<Shot>& shots() {
  static const std::vector<Shot> all{
      {"sand", "oblique", [](Look& look) { look.show = "sand"; }},
      {"snow", "oblique", [](Look& look) { look.show = "snow"; }},
      {"horizon", "oblique", [](Look& look) { look.copies = 3; }},
      {"side", "side", [](Look& look) { look.exaggeration = 2; }},
      {"block", "block", [](Look&) {}},
      {"top", "top", [](Look& look) { look.sun_altitude = 35; }},
      {"no_tufts", "oblique", [](Look& look) { look.tufts = false; }},
      {"elevation", "top", [](Look& look) { look.show = "elevation"; }},
      {"cividis", "oblique", [](Look& look) { look.show = "elevation", look.palette = "cividis"; }},
      {"slope", "top", [](Look& look) { look.show = "slope"; }},
      {"vegetation", "top", [](Look& look) { look.show = "vegetation"; }},
      {"age", "oblique", [](Look& look) { look.show = "age"; }},
      {"shadow", "top", [](Look& look) { look.show = "shadow"; }},
      {"flux", "oblique", [](Look& look) { look.show = "flux"; }},
      {"contours", "top", [](Look& look) { look.show = "elevation", look.palette = "grey", look.contours = 2; }},
      {"wireframe", "oblique", [](Look& look) { look.wireframe = true; }},
      {"raw_cells", "oblique", [](Look& look) { look.raw_cells = true; }},
      {"transparent", "oblique", [](Look& look) { look.transparent = true; }},
  };
  return all;
}

/// What leaves each cell of the terrain in some steps after Werner.
Field flux_of(Terrain terrain) {
  sim::FluxWatch watch(terrain.extent());
  const models::ModelType& type = models::find_model("werner");
  const auto model = type.make(ParameterValues(type.parameters));
  const auto executor = sim::make_executor({.name = "cpu", .threads = 1});
  executor->count_lifts(&watch.counts());
  model->begin(terrain);
  for (std::uint64_t step = 0; step < 4; ++step) {
    model->step(terrain, {270, 5}, {1, step}, *executor);
    watch.stepped();
  }
  return watch.mean();
}

RgbImage shoot(const Shot& shot) {
  const Terrain terrain = landscape();
  render::TerrainView view = view_of(terrain);
  const Field shadow =
      kernels::shadow_field(terrain, 270, kernels::shadow_fall(15, terrain.cell_size(), terrain.quantum()));
  static const Field flux = flux_of(terrain);
  view.fields = {&shadow, &flux};
  view.trajectories = {{{10, 60, 4}, {14, 61, 7}, {18, 62, 8}, {24, 63, 7}, {30, 64, 9}}};
  Look look;
  shot.change(look);
  Renderer renderer;
  const picture::Camera camera = render::camera_preset(shot.camera, Renderer::box_of(view, look), 4.0 / 3);
  return renderer.draw(view, look, camera, {160, 120, 2}).opaque();
}

class Golden : public testing::TestWithParam<std::tuple<Shot, std::string>> {};
INSTANTIATE_TEST_SUITE_P(EveryLook, Golden,
                         testing::Combine(testing::ValuesIn(shots()), testing::Values("osmesa", "egl")),
                         [](const auto& info) { return std::get<0>(info.param).name + "_" + std::get<1>(info.param); });

TEST_P(Golden, LooksAsItDid) {
  const auto& [shot, kind] = GetParam();
  if (kind == "osmesa" && !has_osmesa()) GTEST_SKIP() << "this program was built without OSMesa";
  const std::filesystem::path path =
      std::filesystem::path(ERG_SOURCE_DIR) / "tests" / "render" / "golden" / (shot.name + ".png");
  const auto context = make_offscreen_context(kind);
  const RgbImage drawn = shoot(shot);
  if (std::getenv("ERG_UPDATE_GOLDEN") != nullptr) {
    io::write_png(path, drawn, {});
    GTEST_SKIP() << "written: " << path;
  }
  const Difference apart = difference(drawn, read_picture(path));
  // Another driver or processor rounds otherwise; an eye sees a change of about two in a hundred over a few pixels.
  EXPECT_LT(apart.mean, 1.0);
  EXPECT_LT(apart.largest, 24);
}

TEST(Contexts, OsmesaAndEglAgree) {
  if (!has_osmesa()) GTEST_SKIP() << "this program was built without OSMesa";
  for (const Shot& shot : {shots()[0], shots()[10]}) {
    RgbImage first, second;
    {
      const auto context = make_offscreen_context("osmesa");
      first = shoot(shot);
    }
    {
      const auto context = make_offscreen_context("egl");
      second = shoot(shot);
    }
    const Difference apart = difference(first, second);
    EXPECT_LT(apart.mean, 0.5) << shot.name;
    EXPECT_LT(apart.largest, 12) << shot.name;
  }
}

}  // namespace
}  // namespace erg::test
