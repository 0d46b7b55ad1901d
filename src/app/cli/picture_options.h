// The options of pictures on the command line, and the view of a run that pictures show.
#pragma once

#include <string>

#include "render/look.h"
#include "render/renderer.h"
#include "sim/simulation.h"

namespace CLI {
class App;
class Option_group;
}  // namespace CLI

namespace erg::app {

/// What the command line asks of a picture, in its words.
struct PictureRequest {
  std::string size = "1920x1080";
  std::string camera = "oblique";  ///< a preset, or a JSON file
  std::string sun;                 ///< "285,24": bearing and altitude in degrees; empty: as the look has it
  std::string context = "auto";
  int supersample = 2;
  int copies = -1;  ///< -1: to the horizon for materials on a torus in perspective, none otherwise
  bool no_legend = false;
  render::Look look;
};

/// Adds the options to a command, as a group of their own.
CLI::Option_group& add_picture_options(CLI::App& command, PictureRequest& request);

/// Whether the picture shows what Simulation::watch_flux counts.
inline bool shows_flux(const PictureRequest& request) { return request.look.show == "flux"; }

/// What the request means. Throws InputError with all that is wrong with it.
struct PicturePlan {
  render::PictureSize size;
  render::Look look;
  picture::Camera camera;
};
PicturePlan plan_picture(const PictureRequest& request, const render::TerrainView& view);

/// What pictures show of a run: its terrain, its fields, its wind shadow, its flux where that is watched, and its last
/// wind. Holds what it computes; valid until the next step.
class RunView {
 public:
  explicit RunView(sim::Simulation& simulation);
  /// What a Renderer draws.
  const render::TerrainView& view() const { return view_; }

 private:
  Field shadow_;
  Field flux_;
  render::TerrainView view_;
};

}  // namespace erg::app
