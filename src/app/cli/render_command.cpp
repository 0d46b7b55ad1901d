// `erg render`: a picture of a config's terrain or of a checkpoint.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/notice.h"
#include "app/cli/options.h"
#include "app/cli/output_folder.h"
#include "app/cli/picture_options.h"
#include "app/cli/progress.h"
#include "app/cli/run_setup.h"
#include "core/errors.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/formats/jpeg.h"
#include "io/formats/png.h"
#include "render/gl_context.h"

namespace erg::app {

using render::Picture;
using sim::FluxWatch;
using sim::Simulation;

namespace {

struct RenderRequest {
  std::string source;  ///< config, preset or checkpoint
  std::string out;
  std::int64_t steps = -1;  ///< -1: a config's own number; a checkpoint as it is
  std::vector<std::string> assignments;
  int paths = 0;  ///< trajectories of grains to draw
  bool quiet = false;
  PictureRequest picture;
};

Simulation start(const RenderRequest& request) { return start_from(request.source, request.assignments); }

/// The step that the picture shows.
std::int64_t last_step(const RenderRequest& request, const Simulation& simulation) {
  if (request.steps >= 0) return request.steps;
  return is_checkpoint(request.source) ? simulation.step_count() : simulation.config().run.integer("steps");
}

/// In lower case.
std::string ending_of(const std::string& name) {
  std::string ending = std::filesystem::path(name).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending;
}

bool is_jpeg(const std::string& name) { return ending_of(name) == ".jpg" || ending_of(name) == ".jpeg"; }

/// Refuses what the ending promises and this program does not write.
void check_picture_name(const RenderRequest& request) {
  const std::string ending = ending_of(request.out);
  if (is_jpeg(request.out) && request.picture.look.transparent) {
    throw InputError("--transparent", "a JPEG has no opacity", "give --out a name that ends in .png");
  }
  if (ending.empty() || ending == ".png" || is_jpeg(request.out)) return;
  const std::filesystem::path png = std::filesystem::path(request.out).replace_extension(".png");
  throw InputError("--out " + request.out, "pictures are written as PNG or JPEG",
                   "did you mean \"" + png.string() + "\"?");
}

void write_picture(const std::string& path, const Picture& picture, const io::Provenance& source) {
  if (is_jpeg(path)) {
    io::write_run_jpeg(path, picture.opaque(), source);
  } else {
    io::write_run_png(path, picture.image, source);
  }
}

/// What shows what steps do has to see so many of them.
void check_steps(const RenderRequest& request, const Simulation& simulation, const std::string& option, int steps) {
  if (last_step(request, simulation) > simulation.step_count()) return;
  throw InputError(option, "shows what the last steps do, and here none are done",
                   "ask for more, such as --steps " + std::to_string(simulation.step_count() + steps));
}

/// A wrong option should be known before the run, not after it.
void check_picture(const RenderRequest& request, Simulation& simulation) {
  const bool flux = shows_flux(request.picture);
  simulation.watch_flux(flux);
  plan_picture(request.picture, RunView(simulation).view());
  simulation.watch_flux(false);
  if (flux) check_steps(request, simulation, "--look flux", FluxWatch::steps_of_mean);
  if (request.paths == 0) return;
  if (!simulation.model_type().info.moves_grains) {
    throw InputError("--paths", "the model " + simulation.config().model + " moves no single grains", "leave it out");
  }
  check_steps(request, simulation, "--paths", 1);
}

/// Steps to the state that the picture shows. False when interrupted.
bool grow(const RenderRequest& request, Simulation& simulation) {
  const std::int64_t last = last_step(request, simulation);
  const bool flux = shows_flux(request.picture);
  print_notice(simulation.executor());
  Progress progress(progress_style(request.quiet), simulation.model_type().info.title, simulation.step_count(), last);
  const InterruptGuard guard;
  while (simulation.step_count() < last && !simulation.finished()) {
    if (InterruptGuard::interrupted()) return false;
    if (flux && simulation.step_count() >= last - FluxWatch::steps_of_mean) simulation.watch_flux(true);
    simulation.step();
    print_notice(simulation.executor());
    progress.update(simulation.step_count(), simulation.totals().polls);
  }
  return true;
}

ExitCode render(const RenderRequest& request) {
  check_picture_name(request);
  check_output("--out", request.out);
  Simulation simulation = start(request);
  simulation.keep_trajectories(request.paths);
  const std::unique_ptr<render::GlContext> context = render::make_offscreen_context(request.picture.context);
  render::Renderer renderer;
  check_picture(request, simulation);
  if (!grow(request, simulation)) {
    std::cerr << "Interrupted after step " << simulation.step_count() << "; no picture was written.\n";
    return exit_failed;
  }
  const RunView run(simulation);
  const PicturePlan plan = plan_picture(request.picture, run.view());
  const Picture picture = renderer.draw(run.view(), plan.look, plan.camera, plan.size);
  print_notes(picture.notes);
  write_picture(request.out, picture, io::provenance_of(simulation));
  if (!request.quiet) std::cout << "wrote " << request.out << " (" << context->renderer() << ")\n";
  return exit_done;
}

}  // namespace

void add_render_command(CLI::App& program, Action& action) {
  const auto request = std::make_shared<RenderRequest>();
  CLI::App* command = program.add_subcommand("render", "Draw a picture of a run");
  command->add_option("SOURCE", request->source, "Config file, name of a preset, or checkpoint")->required();
  command->add_option("--out", request->out, "PNG or JPEG file to write")->required();
  command->add_option("--steps", request->steps, "Step to draw (default: a config's last step; a checkpoint's own)")
      ->check(whole_number(0, forcing::most_steps));
  command->add_option("--set", request->assignments, "Change one value of the config: key=value or group.key=value")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command
      ->add_option("--paths", request->paths, "Draw the trajectories of so many grains in the last step (model grains)")
      ->check(whole_number(0, 100000));
  command->add_flag("--quiet", request->quiet, "Print nothing but errors and notes");
  add_instructions_option(*command);
  add_picture_options(*command, request->picture);
  command->callback([&action, request] { action = [request] { return render(*request); }; });
}

}  // namespace erg::app
