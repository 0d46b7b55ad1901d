// `erg gallery`: the pictures of the presets that the window opens with.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/output_folder.h"
#include "app/cli/picture_options.h"
#include "app/cli/presets.h"
#include "app/cli/progress.h"
#include "app/cli/run_setup.h"
#include "io/checkpoint/start_simulation.h"
#include "io/config/config_file.h"
#include "io/formats/jpeg.h"
#include "render/gl_context.h"

namespace erg::app {

using io::Preset;
using io::preset_picture;
using render::Renderer;

namespace {

namespace fs = std::filesystem;

struct GalleryRequest {
  std::vector<std::string> names;  ///< presets; all when empty
  std::string out;                 ///< folder; the presets' own when empty
  bool missing = false;            ///< only those that have no picture yet
  bool quiet = false;
};

std::vector<Preset> wanted_presets(const GalleryRequest& request) {
  if (request.names.empty()) return presets();
  std::vector<Preset> wanted;
  for (const std::string& name : request.names) wanted.push_back(find_preset(name));
  return wanted;
}

PictureRequest gallery_picture() {
  PictureRequest picture;
  picture.size = "320x200";
  picture.supersample = 3;
  picture.no_legend = true;
  return picture;
}

/// Grows a preset to its last step and draws it. False when interrupted.
bool draw_preset(const Preset& preset, const fs::path& file, Renderer& renderer, bool quiet) {
  sim::Simulation simulation = io::start_simulation(io::read_config(preset.path));
  const std::int64_t last = simulation.config().run.integer("steps");
  Progress progress(progress_style(quiet), preset.name, 0, last);
  while (simulation.step_count() < last && !simulation.finished()) {
    if (InterruptGuard::interrupted()) return false;
    simulation.step();
    progress.update(simulation.step_count(), simulation.totals().polls);
  }
  const RunView run(simulation);
  const PicturePlan plan = plan_picture(gallery_picture(), run.view());
  const render::Picture picture = renderer.draw(run.view(), plan.look, plan.camera, plan.size);
  io::write_jpeg(file, picture.opaque());
  return true;
}

ExitCode make_gallery(const GalleryRequest& request) {
  const std::vector<Preset> wanted = wanted_presets(request);
  const fs::path folder = request.out.empty() ? presets_folder() : fs::path(request.out);
  make_folder(folder / "gallery");
  for (const Preset& preset : wanted) {
    const fs::path file = preset_picture(folder, preset.name);
    make_folder(file.parent_path());
    try_output(file.string(), file);
  }
  const std::unique_ptr<render::GlContext> context = render::make_offscreen_context();
  Renderer renderer;
  const InterruptGuard guard;
  for (const Preset& preset : wanted) {
    const fs::path file = preset_picture(folder, preset.name);
    if (request.missing && fs::exists(file)) continue;
    if (!draw_preset(preset, file, renderer, request.quiet)) {
      std::cerr << "Interrupted; the pictures made so far are in " << (folder / "gallery").string() << ".\n";
      return exit_failed;
    }
    if (!request.quiet) std::cout << "wrote " << file.string() << "\n";
  }
  return exit_done;
}

}  // namespace

void add_gallery_command(CLI::App& program, Action& action) {
  const auto request = std::make_shared<GalleryRequest>();
  CLI::App* command = program.add_subcommand("gallery", "Draw the presets' pictures for the window's gallery");
  command->add_option("PRESET", request->names, "Presets (default: all of them)");
  command->add_option("--out", request->out,
                      "Folder in which to make the folder gallery (default: that of the presets)");
  command->add_flag("--missing", request->missing, "Only presets that have no picture yet");
  command->add_flag("--quiet", request->quiet, "Print nothing but errors");
  command->callback([&action, request] { action = [request] { return make_gallery(*request); }; });
}

}  // namespace erg::app
