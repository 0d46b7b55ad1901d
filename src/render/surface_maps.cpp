#include "render/surface_maps.h"

#include <algorithm>
#include <cmath>

namespace erg::render {
namespace {

constexpr int sun_steps = 110;           // most steps towards the skyline below the sun
constexpr int wind_steps = 40;           // and below the wind
constexpr double least_wind_rise = 0.2;  // tangents of the skyline towards the wind below this do not matter

// The rectangles grown by so many cells each way, cut to the grid; on a torus what reaches over an edge comes in again
// on the other side.
std::vector<TexelRect> grown(const std::vector<TexelRect>& rects, int left, int right, int down, int up, Extent extent,
                             bool periodic) {
  std::vector<TexelRect> pieces;
  std::int64_t covered = 0;
  for (const TexelRect& rect : rects) {
    const TexelRect large{rect.left - left, rect.low - down, rect.wide + left + right, rect.high + down + up};
    for (const TexelRect& piece : inside_of(large, extent, periodic)) {
      pieces.push_back(piece);
      covered += static_cast<std::int64_t>(piece.wide) * piece.high;
    }
  }
  constexpr double worth_it = 0.8;  // of the grid: beyond that, one rectangle is cheaper
  if (static_cast<double>(covered) > worth_it * static_cast<double>(extent.cells())) {
    return {{0, 0, extent.nx, extent.ny}};
  }
  return pieces;
}

std::vector<TexelRect> grown(const std::vector<TexelRect>& rects, int reach, const SurfaceSource& source) {
  return grown(rects, reach, reach, reach, reach, source.cells.extent(), source.periodic);
}

// One fragment for each texel of the target that lies over these cells. The program reads a grid of `extent`.
void run_pass(const SurfaceWorkshop& workshop, const SurfaceSource& source, const ShaderProgram& program, Extent extent,
              const MapTarget& target, const std::vector<TexelRect>& where) {
  const Extent cells = source.cells.extent();
  program.set("extent", extent.nx, extent.ny);
  program.set("periodic", static_cast<int>(source.periodic));
  target.bind();
  start_plain_drawing();
  gl11().Enable(GL_SCISSOR_TEST);
  glBindVertexArray(workshop.no_vertices.id());
  const double scale = static_cast<double>(target.size().nx) / cells.nx;
  for (const TexelRect& rect : where) {
    const auto edge = [scale](int cell) { return static_cast<int>(std::floor(cell * scale)); };
    const int right = static_cast<int>(std::ceil((rect.left + rect.wide) * scale));
    const int top = static_cast<int>(std::ceil((rect.low + rect.high) * scale));
    gl11().Scissor(edge(rect.left), edge(rect.low), right - edge(rect.left), top - edge(rect.low));
    gl11().DrawArrays(GL_TRIANGLES, 0, 3);
  }
  gl11().Disable(GL_SCISSOR_TEST);
  glBindVertexArray(0);
}

}  // namespace

// One smoothing: the radius of the planes, how far they are asked and count (cells), and the misfit and distance that
// they may have (slabs).
struct SurfaceMaps::Smoothing {
  int detail, plane_reach, reach;
  double spread, noise, tolerance;
  int block = 1;  ///< cells of the terrain in one that is smoothed, where that is to be made good for
};

SurfaceWorkshop::SurfaceWorkshop(const std::filesystem::path& shaders)
    : rows(shaders, "pass.vert", "rows.frag"),
      planes(shaders, "pass.vert", "planes.frag"),
      smooth(shaders, "pass.vert", "smooth.frag"),
      raw(shaders, "pass.vert", "raw.frag"),
      shape(shaders, "pass.vert", "shape.frag"),
      light(shaders, "pass.vert", "light.frag"),
      no_vertices(GlObject::vertex_array()) {}

void SurfaceMaps::update(SurfaceWorkshop& workshop, const SurfaceSource& source, const LightSource& light,
                         const RenderQuality& quality, const std::vector<TexelRect>& changed) {
  const Extent cells = source.cells.extent();
  const std::vector<TexelRect> everywhere{{0, 0, cells.nx, cells.ny}};
  const int most = std::min(quality.largest_map, largest_texture());
  detail_ = !source.raw && 2 * std::max(cells.nx, cells.ny) <= most ? 2 : 1;
  const std::vector<double> surface_key{source.raw ? 1.0 : 0.0,
                                        static_cast<double>(detail_),
                                        source.quantum,
                                        source.cell_side,
                                        static_cast<double>(quality.smoothings),
                                        static_cast<double>(cells.nx),
                                        static_cast<double>(cells.ny)};
  const std::vector<double> light_key{quality.light_share, quality.light_stride,
                                      static_cast<double>(quality.sky_directions),
                                      static_cast<double>(quality.sky_steps)};
  const bool surface_new = surface_key != surface_key_;
  const bool light_new = surface_new || light_key != light_key_ || !(light == lit_by_);
  if (surface_new || !changed.empty()) {
    compute_surface(workshop, source, quality, surface_new ? everywhere : changed);
  }
  if (light_new || !changed.empty()) compute_light(workshop, source, light, quality, light_new ? everywhere : changed);
  surface_key_ = surface_key;
  light_key_ = light_key;
  lit_by_ = light;
}

// Each stage is computed as far around as the next one looks.
void SurfaceMaps::compute_surface(SurfaceWorkshop& workshop, const SurfaceSource& source, const RenderQuality& quality,
                                  const std::vector<TexelRect>& where) {
  const Extent cells = source.cells.extent();
  surface_.prepare({cells.nx * detail_, cells.ny * detail_}, GL_RG32F, source.periodic);
  shape_.prepare(surface_.size(), GL_RGBA32F, source.periodic);
  // In the mean of a block single slabs are gone by themselves: a quick picture must not take low dunes, which are only
  // some blocks wide, away with them.
  const int wide = quality.smoothings == 1 ? source.block : 1;
  // Single slabs go first, then, on what is left, the bumps of a few cells that they made.
  const Smoothing slabs{.detail = quality.smoothings == 1 ? detail_ : 1,
                        .plane_reach = (3 + wide - 1) / wide,
                        .reach = quality.smoothings == 1 ? (2 + wide - 1) / wide : 3,
                        .spread = 1.5,
                        .noise = 0.4,
                        .tolerance = 0.8,
                        .block = wide};
  const Smoothing bumps{
      .detail = detail_, .plane_reach = 4, .reach = 4, .spread = 2.2, .noise = 0.12, .tolerance = 0.3};
  const auto reach_of = [](const Smoothing& smoothing) { return smoothing.plane_reach + smoothing.reach + 1; };
  if (source.raw) {
    workshop.raw.use();
    workshop.raw.set_texture("cells", 0, source.cells.id());
    run_pass(workshop, source, workshop.raw, source.cells.extent(), surface_, where);
  } else if (quality.smoothings == 1) {
    smooth_into(workshop, source, surface_, source.cells.id(), slabs, grown(where, reach_of(slabs), source));
  } else {
    const std::vector<TexelRect> reached = grown(where, reach_of(slabs) + reach_of(bumps), source);
    workshop.first_surface.prepare(cells, GL_RG32F, source.periodic);
    smooth_into(workshop, source, workshop.first_surface, source.cells.id(), slabs,
                grown(reached, reach_of(bumps), source));
    smooth_into(workshop, source, surface_, workshop.first_surface.id(), bumps, reached);
  }
  const int reach = source.raw ? 2 : reach_of(slabs) + (quality.smoothings == 1 ? 0 : reach_of(bumps)) + 2;
  const std::vector<TexelRect> reached = grown(where, reach, source);
  workshop.shape.use();
  workshop.shape.set("texel_side", source.cell_side / detail_);
  workshop.shape.set("raw_cells", static_cast<int>(source.raw));
  workshop.shape.set_texture("cells", 0, surface_.id());
  run_pass(workshop, source, workshop.shape, surface_.size(), shape_, reached);
  for (const TexelRect& rect : reached) {
    computed_texels_ += static_cast<std::int64_t>(rect.wide) * rect.high * detail_ * detail_;
  }
}

void SurfaceMaps::smooth_into(SurfaceWorkshop& workshop, const SurfaceSource& source, const MapTarget& target,
                              GLuint cells, const Smoothing& smoothing, const std::vector<TexelRect>& where) const {
  // Where slabs are thin there is little to smooth away; the ground itself is not smoother than a share of a cell.
  const double cell = source.cell_side / smoothing.block;
  const double noise = std::max(smoothing.noise * source.quantum, 0.005 * cell);
  const double tolerance = std::max(smoothing.tolerance * source.quantum, 0.03 * cell);
  const std::vector<TexelRect> asked = grown(where, smoothing.reach, source);
  workshop.row_sums.prepare(source.cells.extent(), GL_RGBA32F, source.periodic);
  workshop.rows.use();
  workshop.rows.set("reach", smoothing.plane_reach);
  workshop.rows.set_texture("cells", 0, cells);
  run_pass(workshop, source, workshop.rows, source.cells.extent(), workshop.row_sums,
           grown(asked, smoothing.plane_reach, source));
  workshop.fits.prepare(source.cells.extent(), GL_RGBA32F, source.periodic);
  workshop.planes.use();
  workshop.planes.set("reach", smoothing.plane_reach);
  workshop.planes.set("noise", noise);
  workshop.planes.set_texture("cells", 0, workshop.row_sums.id());
  run_pass(workshop, source, workshop.planes, source.cells.extent(), workshop.fits, asked);
  workshop.smooth.use();
  workshop.smooth.set("detail", smoothing.detail);
  workshop.smooth.set("reach", smoothing.reach);
  workshop.smooth.set("sharpness", 1 / (2 * smoothing.spread * smoothing.spread));
  workshop.smooth.set("strictness", 1 / (2 * tolerance * tolerance));
  workshop.smooth.set_texture("planes", 1, workshop.fits.id());
  workshop.smooth.set_texture("cells", 0, cells);
  run_pass(workshop, source, workshop.smooth, source.cells.extent(), target, where);
}

void SurfaceMaps::compute_light(SurfaceWorkshop& workshop, const SurfaceSource& source, const LightSource& light,
                                const RenderQuality& quality, const std::vector<TexelRect>& where) {
  const auto share = [&](int texels) {
    return std::max(1, static_cast<int>(std::lround(quality.light_share * texels)));
  };
  light_.prepare({share(surface_.size().nx), share(surface_.size().ny)}, GL_RGBA16F, source.periodic);
  const double step_length = source.cell_side * source.cells.extent().nx / light_.size().nx;
  const double sun_rise = std::max(0.02, 0.8 * light.sun_tangent);
  // What changed at a place is seen from as far as light.frag looks: around it, and down the sun and the wind.
  const double sky_reach = 1.5 * std::pow(1.7, quality.sky_steps - 1);  // texels
  const double around = 24 + sky_reach * step_length / source.cell_side;
  const double down_sun = (light.high - light.low) / sun_rise / source.cell_side + around;
  const double down_wind = (light.high - light.low) / least_wind_rise / source.cell_side + around;
  const auto reach = [&](int axis, int sign) {
    const auto part = static_cast<std::size_t>(axis);
    return static_cast<int>(std::ceil(std::max({around, down_sun * -sign * static_cast<double>(light.to_sun[part]),
                                                down_wind * -sign * static_cast<double>(light.to_wind[part])})));
  };
  const std::vector<TexelRect> reached =
      grown(where, reach(0, -1), reach(0, 1), reach(1, -1), reach(1, 1), source.cells.extent(), source.periodic);
  const ShaderProgram& program = workshop.light;
  program.use();
  program.set("texel", 1.0f / static_cast<float>(light_.size().nx), 1.0f / static_cast<float>(light_.size().ny));
  program.set("step_length", step_length);
  program.set("stride", quality.light_stride);
  program.set("sky_directions", quality.sky_directions);
  program.set("sky_steps", quality.sky_steps);
  program.set("exaggeration", light.exaggeration);
  program.set("highest", light.high);
  program.set("sun_rise", sun_rise);
  program.set("wind_rise", least_wind_rise);
  program.set("to_sun", light.to_sun[0], light.to_sun[1]);
  program.set("to_wind", light.to_wind[0], light.to_wind[1]);
  program.set("sun_steps", sun_steps);
  program.set("wind_steps", wind_steps);
  program.set_texture("surface", 0, surface_.id());
  run_pass(workshop, source, program, surface_.size(), light_, reached);
}

}  // namespace erg::render
