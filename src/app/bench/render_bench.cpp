#include "app/bench/render_bench.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>

#include "app/bench/bench.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "render/textures.h"
#include "sim/scene.h"

namespace erg::app {

using render::Renderer;
using render::RenderQuality;

namespace {

constexpr render::PictureSize bench_size{.width = 1280, .height = 720, .supersample = 1};

/// The least of several turns.
template <typename Work>
PictureTime time_of(int turns, const Work& work) {
  PictureTime least{1e9, 1e9};
  for (int turn = 0; turn < turns; ++turn) {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t busy = std::clock();
    work();
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    least.wall = std::min(least.wall, wall.count());
    least.processor = std::min(least.processor, static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC);
  }
  return least;
}

/// Transverse dunes, as they stand before the first step.
Terrain bench_terrain(int grid) {
  return sim::build_scene(bench_config("momiji", grid, {"scene.kind=transverse"}), 1.0 / 3);
}

RenderBenchRow measure(Terrain& terrain, const RenderQuality& quality, const std::string& name, int turns) {
  Renderer renderer;
  renderer.set_quality(quality);
  render::TerrainView view;
  view.terrain = &terrain;
  view.wind = 270;
  std::uint64_t version = 1;
  view.version = version;
  render::Look look;
  picture::Camera camera = render::camera_preset("oblique", Renderer::box_of(view, look),
                                                 static_cast<double>(bench_size.width) / bench_size.height);
  render::PictureTarget target;
  target.prepare(bench_size.width, bench_size.height);
  const auto draw = [&] {
    renderer.draw_into(target.frame(), view, look, camera, bench_size.width, bench_size.height);
    render::gl11().Finish();
  };
  const auto change = [&](int rows) {
    Grid<std::int32_t>& mobile = terrain.edit_mobile();
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < terrain.nx(); ++x) mobile(x, y) += (x + y) % 2;
    }
    view.version = ++version;
    draw();
  };

  RenderBenchRow row;
  row.grid = terrain.nx();
  row.quality = name;
  row.first = time_of(1, draw);
  row.turned = time_of(turns, [&] {
    render::orbit(camera, 5, 0);
    draw();
  });
  row.tenth = time_of(turns, [&] { change(terrain.ny() / 10); });
  row.all = time_of(turns, [&] { change(terrain.ny()); });
  row.triangles = renderer.draw(view, look, camera, bench_size).triangles;
  const int block = (terrain.nx() + quality.largest_side - 1) / quality.largest_side;
  const std::string side = std::to_string(terrain.nx() / block);
  row.drawn = side + " x " + side;
  return row;
}

}  // namespace

std::vector<RenderBenchRow> run_render_bench(const std::vector<int>& grids, const std::string& context_kind,
                                             std::string& renderer) {
  const auto context = render::make_offscreen_context(context_kind);
  renderer = context->renderer();
  std::vector<RenderBenchRow> rows;
  for (const int grid : grids) {
    std::cerr << "drawing " << grid << " x " << grid << " cells\n";
    Terrain terrain = bench_terrain(grid);
    rows.push_back(measure(terrain, RenderQuality::moving(context->is_software()), "moving", 5));
    rows.push_back(measure(terrain, RenderQuality::still(), "still", 1));
  }
  return rows;
}

}  // namespace erg::app
