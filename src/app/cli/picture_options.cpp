#include "app/cli/picture_options.h"

#include <filesystem>
#include <optional>

#include "app/cli/known_words.h"
#include "app/cli/options.h"
#include "core/errors.h"
#include "core/number_text.h"
#include "forcing/bearing.h"
#include "io/files/given_file.h"
#include "io/formats/camera_file.h"
#include "kernels/shadow.h"
#include "render/gl_context.h"

namespace erg::app {
namespace {

render::PictureSize parse_size(const std::string& text, int supersample) {
  const std::size_t cross = text.find('x');
  if (cross != std::string::npos) {
    const auto width = number_from<int>(std::string_view(text).substr(0, cross));
    const auto height = number_from<int>(std::string_view(text).substr(cross + 1));
    if (width && height && *width > 0 && *height > 0) return {*width, *height, supersample};
  }
  throw InputError("--size " + text, "is no size", "give width and height in pixels, such as 1920x1080");
}

void parse_sun(const std::string& text, render::Look& look) {
  const std::size_t comma = text.find(',');
  const auto altitude =
      comma == std::string::npos ? std::nullopt : number_from<double>(std::string_view(text).substr(comma + 1));
  if (!altitude) {
    throw InputError("--sun " + text, "is no place of the sun", "give bearing and altitude, such as 285,24 or W,30");
  }
  look.sun_bearing = forcing::parse_bearing(std::string_view(text).substr(0, comma), "--sun " + text);
  look.sun_altitude = *altitude;
}

picture::Camera find_camera(const std::string& name, const render::TerrainBox& box, double aspect) {
  return io::file_trouble(name, "camera file") ? render::camera_preset(name, box, aspect) : io::read_camera(name);
}

}  // namespace

CLI::Option_group& add_picture_options(CLI::App& program, PictureRequest& request) {
  CLI::Option_group& command = *program.add_option_group("Pictures");
  command.add_option("--size", request.size, "Width and height in pixels")->capture_default_str();
  command.add_option("--camera", request.camera, "top, oblique, block, side, or a JSON file")->capture_default_str();
  command
      .add_option("--look", request.look.show,
                  "material, sand, snow, elevation, slope, shadow, flux, or a field of the model")
      ->capture_default_str();
  command.add_option("--palette", request.look.palette, "Colours of values: RdYlGn, cividis, batlow, grey ...");
  command.add_option("--contours", request.look.contours, "Interval of contour lines, in the unit of what is shown")
      ->check(finite_number());
  command.add_option("--sun", request.sun, "Bearing and altitude of the sun in degrees (default 285,24)");
  command.add_option("--exaggeration", request.look.exaggeration, "Factor on all heights")
      ->capture_default_str()
      ->check(finite_number());
  command.add_option("--grain", request.look.grain, "Strength of grains and ripples, 0 to 1")
      ->capture_default_str()
      ->check(finite_number());
  command
      .add_option("--copies", request.copies,
                  "Rings of copies around a torus (default: to the horizon for materials in perspective)")
      ->check(whole_number(0, 8));
  command.add_option("--supersample", request.supersample, "Pixels drawn for each pixel, each way")
      ->capture_default_str()
      ->check(whole_number(1, 4));
  command.add_option("--context", request.context, "What draws: auto, egl, osmesa")
      ->capture_default_str()
      ->check(one_of(render::offscreen_kinds()));
  command.add_flag("--wireframe", request.look.wireframe, "Show the edges of the strips");
  command.add_flag("--raw", request.look.raw_cells, "Straight lines from cell to cell, no smoothing");
  command.add_flag("--transparent", request.look.transparent, "Nothing behind the terrain, nothing written over it");
  command.add_flag("--no-legend", request.no_legend, "No legend, wind arrow and scale bar");
  return command;
}

PicturePlan plan_picture(const PictureRequest& request, const render::TerrainView& view) {
  PicturePlan plan;
  plan.size = parse_size(request.size, request.supersample);
  plan.look = request.look;
  plan.look.legend = !request.no_legend;
  if (!request.sun.empty()) parse_sun(request.sun, plan.look);
  render::check_look(plan.look, view);
  const double aspect = static_cast<double>(plan.size.width) / plan.size.height;
  plan.camera = find_camera(request.camera, render::Renderer::box_of(view, plan.look), aspect);
  constexpr int to_the_horizon = 6;
  const bool horizon =
      plan.look.is_material() && request.camera != "block" && !plan.camera.orthographic && !plan.look.transparent;
  plan.look.copies = request.copies >= 0 ? request.copies : horizon ? to_the_horizon : 0;
  return plan;
}

RunView::RunView(sim::Simulation& simulation) {
  const Terrain& terrain = simulation.terrain();
  const forcing::Forcing wind = simulation.last_wind();
  shadow_ = kernels::shadow_field(terrain, wind.bearing, simulation.model().shadow_fall(terrain.cell_size()));
  view_.terrain = &terrain;
  view_.fields = {&shadow_};
  if (simulation.flux() != nullptr) {
    flux_ = simulation.flux()->mean();
    view_.fields.push_back(&flux_);
  }
  view_.wind = wind.mean_bearing();
  view_.trajectories = simulation.model().trajectories();
  view_.material = simulation.model_type().info.material;
}

}  // namespace erg::app
