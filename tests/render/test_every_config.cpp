// Every config that comes with the program: loaded, run a few steps, drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/config/preset_list.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene.h"

namespace erg::test {

using io::Preset;
using picture::RgbImage;
using render::Renderer;
using sim::Config;

namespace {

constexpr std::int64_t most_cells_a_side = 80;  // a few seconds for all of them
constexpr int steps = 4;

Config reduced(const std::filesystem::path& path) {
  Config config = io::read_config(path);
  for (const char* side : {"nx", "ny"}) {
    config.grid.set(side, std::min(config.grid.integer(side), most_cells_a_side));
  }
  config.run.set("threads", std::int64_t{2});
  return config;
}

/// The share of the picture that has its most frequent colour.
double largest_share(const RgbImage& image) {
  std::map<std::array<std::uint8_t, 3>, int> counts;
  int most = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const std::uint8_t* const pixel = image.pixel(x, y);
      most = std::max(most, ++counts[{pixel[0], pixel[1], pixel[2]}]);
    }
  }
  return static_cast<double>(most) / (image.width * image.height);
}

TEST(EveryConfig, IsLoadedRunAndDrawn) {
  const std::vector<Preset> presets = io::list_presets(std::filesystem::path(ERG_SOURCE_DIR) / "cfg");
  ASSERT_GE(presets.size(), 65u) << "those of cfg/, cfg/thesis and cfg/szabo2019";
  const std::unique_ptr<render::GlContext> context = render::make_offscreen_context(usual_context());
  Renderer renderer;
  const auto top_view = [&renderer](const Terrain& terrain) {
    render::Look look;
    look.legend = false;
    const render::TerrainView view = view_of(terrain);
    return renderer.draw(view, look, render::camera_preset("top", Renderer::box_of(view, look), 1), {80, 80, 1})
        .opaque();
  };
  for (const Preset& preset : presets) {
    SCOPED_TRACE(preset.name);
    sim::Simulation simulation = io::start_simulation(reduced(preset.path));
    const RgbImage before = top_view(simulation.terrain());
    for (int step = 0; step < steps; ++step) simulation.step();
    const Terrain& terrain = simulation.terrain();
    const MassLedger& ledger = terrain.ledger();
    EXPECT_EQ(terrain.total_mobile(), ledger.start + ledger.in - ledger.out);
    const RgbImage after = top_view(terrain);
    EXPECT_LT(largest_share(after), 0.5) << "the picture is of one colour";
    if (preset.name == "flat_crust") continue;  // it is there to show that nothing moves
    EXPECT_GT(simulation.totals().lifts, 0) << "nothing moved";
    EXPECT_GT(difference(before, after).largest, 0.25) << "the picture shows nothing of what moved";
  }
}

}  // namespace
}  // namespace erg::test
