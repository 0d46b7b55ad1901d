// `erg gui`, and `erg` alone: the window.
#include "app/gui/gui_command.h"

#include <cstdio>
#include <memory>

#include "app/cli/interrupt.h"
#include "app/cli/options.h"
#include "app/cli/presets.h"
#include "core/errors.h"
#include "session/settings.h"
#include "ui/window/desktop.h"

namespace erg::app {

using session::Settings;
using ui::DesktopRequest;

namespace {

ExitCode open_window(DesktopRequest request, const std::string& config) {
  if (!config.empty()) request.open = config_path(config);
  request.folders = {session::settings_folder(), session::state_folder(), presets_folder()};
  request.asked_to_end = InterruptGuard::interrupted;
  try {
    const InterruptGuard guard;
    ui::run_desktop(request);
  } catch (const InputError& error) {
    // No display, or no OpenGL on it: nothing that was given is wrong.
    for (const Mistake& mistake : error.mistakes()) std::fprintf(stderr, "erg: %s\n", mistake.text().c_str());
    return exit_failed;
  }
  return exit_done;
}

}  // namespace

void add_gui_command(CLI::App& program, Action& action) {
  const auto request = std::make_shared<DesktopRequest>();
  const auto config = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("gui", "Open the window (so does `erg` alone)");
  command->add_option("CONFIG", *config, "Config file, name of a preset, or checkpoint (default: the gallery)");
  command->add_option("--scale", request->scale, "Size of text and controls (default: as the screen suggests)")
      ->check(CLI::Range(Settings::smallest_scale, Settings::largest_scale));
  command->add_option("--width", request->width, "Width of the window in pixels")->check(whole_number(640, 16384));
  command->add_option("--height", request->height, "Height of the window in pixels")->check(whole_number(480, 16384));
  command->add_option("--ui-map", request->widget_map,
                      "Testing aid: keep a list of all widgets and where they lie in this file");
  command->callback(
      [&action, request, config] { action = [request, config] { return open_window(*request, *config); }; });
}

ExitCode open_gallery_window() { return open_window({}, {}); }

}  // namespace erg::app
