#include "app/render_bench.h"

#include <chrono>
#include <iostream>

#include "render/gl_context.h"
#include "render/renderer.h"
#include "sim/scene.h"

namespace erg {
namespace {

constexpr PictureSize bench_size{.width = 1280, .height = 720, .supersample = 1};

template <typename Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Transverse dunes, as they stand before the first step.
Terrain bench_land(int grid) {
  Config config;
  set_from_text(config, "grid.nx=" + std::to_string(grid));
  set_from_text(config, "grid.ny=" + std::to_string(grid));
  set_from_text(config, "scene.kind=transverse");
  return build_scene(config, 1.0 / 3);
}

RenderBenchRow measure(Terrain& terrain, const RenderEffort& effort, const std::string& quality) {
  Renderer renderer;
  renderer.set_effort(effort);
  TerrainView view;
  view.terrain = &terrain;
  view.wind = 270;
  std::uint64_t version = 1;
  view.version = version;
  Look look;
  Camera camera = camera_preset("oblique", Renderer::land_of(view, look),
                                static_cast<double>(bench_size.width) / bench_size.height);
  Picture picture;
  const auto draw = [&] { picture = renderer.draw(view, look, camera, bench_size); };

  RenderBenchRow row;
  row.grid = terrain.nx();
  row.quality = quality;
  row.first = seconds(draw);
  orbit(camera, 5, 1);
  row.turned = seconds(draw);
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (int y = 0; y < terrain.ny() / 10; ++y) {
    for (int x = 0; x < terrain.nx(); ++x) mobile(x, y) += (x + y) % 2;
  }
  view.version = ++version;
  row.changed = seconds(draw);
  row.triangles = picture.triangles;
  const int block = (terrain.nx() + effort.largest_side - 1) / effort.largest_side;
  const std::string side = std::to_string(terrain.nx() / block);
  row.drawn = side + " x " + side;
  return row;
}

}  // namespace

std::vector<RenderBenchRow> run_render_bench(const std::vector<int>& grids, const std::string& context_kind,
                                             std::string& renderer) {
  const auto context = make_offscreen_context(context_kind);
  renderer = context->renderer();
  std::vector<RenderBenchRow> rows;
  for (const int grid : grids) {
    std::cerr << "drawing " << grid << " x " << grid << " cells\n";
    Terrain terrain = bench_land(grid);
    rows.push_back(measure(terrain, RenderEffort::moving(context->is_software()), "moving"));
    rows.push_back(measure(terrain, RenderEffort::still(), "still"));
  }
  return rows;
}

}  // namespace erg
