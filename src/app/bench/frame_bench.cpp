#include "app/bench/frame_bench.h"

#include <algorithm>
#include <ctime>
#include <iostream>

#include "app/bench/bench.h"
#include "core/surface_range.h"
#include "render/block_window.h"
#include "render/gl_context.h"
#include "render/quality.h"
#include "render/textures.h"
#include "sim/simulation.h"

namespace erg::app {
namespace {

constexpr int frames = 5;

/// The least of what it was and what this takes.
template <typename Work>
void measure(double& least, const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
}

FrameBenchRow measure_frames(int grid) {
  constexpr double never = 1e9;
  FrameBenchRow row{grid, never, never, never, never, never, never};
  sim::Simulation simulation(bench_config("momiji", grid, {"scene.kind=transverse"}));
  const render::BlockWindow window =
      render::whole_window(simulation.terrain().mobile().extent(), render::RenderQuality::still().largest_side);
  Terrain copy;
  std::vector<float> values;
  render::TiledTexture texture(2);
  SurfaceRange range;
  for (int frame = 0; frame <= frames; ++frame) {
    if (frame == 1) row = {grid, never, never, never, never, never, never};  // the first takes its memory
    simulation.step();
    measure(row.settling, [&] { simulation.terrain(); });
    measure(row.copying, [&] { copy = simulation.terrain(); });
    measure(row.ranges, [&] { range = surface_range(copy); });
    measure(row.reading, [&] { render::read_terrain(copy, window, values); });
    double update = never;
    measure(update, [&] {
      texture.update(window.blocks, true, values);
      render::gl11().Finish();
    });
    double compare = never;
    measure(compare, [&] { texture.update(window.blocks, true, values); });
    row.comparing = std::min(row.comparing, compare);
    row.uploading = std::min(row.uploading, std::max(0.0, update - compare));
  }
  return row;
}

}  // namespace

std::vector<FrameBenchRow> run_frame_bench(const std::vector<int>& grids, const std::string& context,
                                           std::string& renderer) {
  const auto drawing = render::make_offscreen_context(context);
  renderer = drawing->renderer();
  std::vector<FrameBenchRow> rows;
  for (const int grid : grids) {
    std::cerr << "frames of " << grid << " x " << grid << " cells\n";
    rows.push_back(measure_frames(grid));
  }
  return rows;
}

}  // namespace erg::app
