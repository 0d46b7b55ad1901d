// `erg run`: grows dunes from a config.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/film.h"
#include "app/cli/interrupt.h"
#include "app/cli/known_words.h"
#include "app/cli/measured_run.h"
#include "app/cli/notice.h"
#include "app/cli/options.h"
#include "app/cli/output_folder.h"
#include "app/cli/progress.h"
#include "app/cli/run_output.h"
#include "app/cli/run_setup.h"
#include "app/cli/tell.h"
#include "app/cli/text_table.h"
#include "app/cli/way_on.h"
#include "core/number_text.h"
#include "forcing/bearing.h"
#include "io/config/provenance.h"
#include "io/files/atomic_file.h"
#include "io/files/held_name.h"
#include "sim/step_time.h"

namespace erg::app {

using forcing::most_steps;
using io::RunMeter;
using sim::Simulation;

namespace {

// Rows of the CSV, where --every does not say. A row has a spectrum, which costs more than a step.
constexpr std::int64_t default_rows = 50;
constexpr std::int64_t default_row_gap = 10;  // steps, at least

constexpr std::size_t saving_bytes = std::size_t{16} << 20;  // more than a checkpoint takes to be written

std::int64_t steps_between_rows(const RunRequest& request, std::int64_t last) {
  return request.every > 0 ? request.every : std::max(default_row_gap, last / default_rows);
}

/// What a run writes.
struct Outputs {
  std::unique_ptr<io::HeldName> name;  ///< under which it writes them, alone
  std::unique_ptr<RunOutput> files;    ///< null: none
  std::unique_ptr<Film> film;          ///< null: none
};

bool needs_numbers(const RunRequest& request) { return !request.quiet || !request.stats.empty(); }

/// The run itself: step, write, show; until the last step or Ctrl-C.
void run_steps(const RunRequest& request, Simulation& simulation, MeasuredRun& run, const Outputs& outputs) {
  RunOutput* const output = outputs.files.get();
  Film* const film = outputs.film.get();
  const std::int64_t last = simulation.config().run.integer("steps");
  const std::int64_t row_every = steps_between_rows(request, last);
  print_notice(simulation.executor());
  Progress progress(progress_style(request.quiet), simulation.model_type().info.title, simulation.step_count(), last);
  if (output != nullptr) output->add_row();
  if (film != nullptr) film->add_frame(simulation);
  while (!run.finished() && !InterruptGuard::interrupted()) {
    run.step();
    print_notice(simulation.executor());
    progress.update(simulation.step_count(), run.polls());
    if (film != nullptr && simulation.step_count() % request.frames == 0) film->add_frame(simulation);
    if (output == nullptr) continue;
    const bool end = run.finished();
    const std::int64_t soon = simulation.step_count() + RunMeter::good_look;
    if (row_every > RunMeter::good_look && (soon == last || soon % row_every == 0)) output->glance();
    if (end || simulation.step_count() % row_every == 0) output->add_row();
    if (!end && request.every > 0 && simulation.step_count() % request.every == 0) output->write_state();
  }
}

std::string crests_text(const analysis::SpectrumNumbers& spectrum) {
  const std::string alignment = "alignment " + fixed_text(spectrum.alignment, 2);
  if (!spectrum.crest_bearing) return "along no one bearing (" + alignment + ")";
  return "along " + fixed_text(*spectrum.crest_bearing, 0) + "° (" + alignment + ")";
}

std::string migration_text(const analysis::Shift& migration) {
  const double speed = std::hypot(migration.x, migration.y);
  const std::string text = fixed_text(speed, 3) + " cells a step";
  if (!(speed > 0)) return text;
  // Of what moves toward (x, y), as opposed to a wind that blows from there.
  return text + " toward " + fixed_text(forcing::bearing_of({-migration.x, -migration.y}), 0) + "°";
}

void print_summary(Simulation& simulation, const RunStatistics& numbers) {
  std::cout << simulation.model_type().info.title << ": " << simulation.step_count() << " steps, "
            << duration_text(numbers.seconds) << " (" << fixed_text(numbers.polls_per_second / 1e6, 1)
            << " million polls/s, " << io::executor_text(simulation.executor().name(), simulation.executor().threads())
            << ")\n";
  if (simulation.finished()) std::cout << "  ended early: " << simulation.totals().why_finished << "\n";
  std::cout << "  thickest column " << numbers.shape.max_slabs << " slabs, standard deviation "
            << fixed_text(numbers.shape.sd_slabs, 2) << ", bare " << fixed_text(numbers.shape.bare_fraction * 100, 1)
            << "%, in shadow " << fixed_text(numbers.shadow_fraction * 100, 1) << "%\n"
            << "  crests " << fixed_text(numbers.crest_spacing, 1) << " cells apart, " << crests_text(numbers.spectrum)
            << ", migration " << migration_text(numbers.migration) << "\n";
  const double seconds = sim::step_scale(simulation.config()).seconds * static_cast<double>(simulation.step_count());
  if (seconds > 0) std::cout << "  in the world " << sim::world_time_text(seconds) << "\n";
}

const std::vector<std::string>& formats(const RunRequest& request) {
  return request.formats.empty() ? usual_formats() : request.formats;
}

void check_flux(const RunRequest& request) {
  if (!request.flux) return;
  const std::vector<std::string>& written = formats(request);
  if (writes_files(request) && std::find(written.begin(), written.end(), "vti") != written.end()) return;
  throw InputError("--flux", "is written into VTI files, and none are asked for", "add --format vti");
}

/// Tries and makes them all: nothing is run where one of them cannot be written.
Outputs make_outputs(const RunRequest& request, const PictureRequest& picture, Simulation& simulation) {
  Outputs outputs;
  const std::string folder = output_folder(request);
  if (request.frames > 0 || writes_files(request)) {
    make_folder(folder);
    outputs.name = std::make_unique<io::HeldName>(std::filesystem::path(folder) / run_name(request));
  }
  if (request.frames > 0) {
    outputs.film = std::make_unique<Film>(folder, run_name(request), request.frames, picture, simulation);
  }
  if (writes_files(request)) {
    check_output("--stats", request.stats);
    outputs.files = std::make_unique<RunOutput>(folder, run_name(request), formats(request), simulation);
  }
  return outputs;
}

/// All that a run's end brings but the film.
void finish(const RunRequest& request, Simulation& simulation, MeasuredRun& measured, RunOutput* files) {
  if (files != nullptr) files->write_state();
  if (needs_numbers(request)) {
    const RunStatistics numbers = measured.statistics();
    if (!request.stats.empty()) io::write_file_atomically(request.stats, statistics_json(simulation, numbers));
    if (!request.quiet) print_summary(simulation, numbers);
  }
  if (files != nullptr && !request.quiet) {
    for (const auto& path : files->files()) std::cout << "  wrote " << path.string() << "\n";
  }
  if (request.hash) std::cout << hash_text(state_hash(simulation.terrain())) << "\n";
}

/// Whatever goes wrong once a step is done, the run is saved.
ExitCode grow(const RunRequest& request, Simulation& simulation, MeasuredRun& measured, const Outputs& outputs) {
  const std::int64_t first = simulation.step_count();
  const InterruptGuard guard;
  // Where memory is short, saving takes some too.
  std::vector<char> reserve;
  reserve.reserve(saving_bytes);
  try {
    run_steps(request, simulation, measured, outputs);
    if (measured.finished()) {
      finish(request, simulation, measured, outputs.files.get());
      return exit_done;
    }
    save_and_tell(request, simulation, outputs.files.get(), "Interrupted");
  } catch (const std::exception& error) {
    if (simulation.step_count() == first) throw;
    std::vector<char>().swap(reserve);
    tell(error);
    save_and_tell(request, simulation, outputs.files.get(), "The run ended");
  }
  return exit_failed;
}

ExitCode run(const RunRequest& request, const PictureRequest& picture) {
  check_output("--stats", request.stats, writes_files(request) ? output_folder(request) : "");
  check_flux(request);
  Simulation simulation = start_simulation(request);
  simulation.watch_flux(request.flux || (request.frames > 0 && shows_flux(picture)));
  const Outputs outputs = make_outputs(request, picture, simulation);
  MeasuredRun measured(simulation, simulation.config().run.integer("steps"), needs_numbers(request));
  const ExitCode ended = grow(request, simulation, measured, outputs);
  if (ended == exit_done && outputs.film != nullptr) outputs.film->finish(request.quiet);
  return ended;
}

}  // namespace

void add_run_command(CLI::App& program, Action& action) {
  const auto request = std::make_shared<RunRequest>();
  const auto picture = std::make_shared<PictureRequest>();
  CLI::App* command = program.add_subcommand("run", "Grow dunes from a config");
  command->add_option("CONFIG", request->config, "Config file, or the name of a preset");
  command->add_option("--set", request->assignments, "Change one value of the config: key=value or group.key=value")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  const Parameters declared = sim::run_parameters();
  for (const Parameter& parameter : declared) {
    command
        ->add_option_function<std::string>(
            "--" + parameter.key,
            [request, key = parameter.key](const std::string& value) { request->options[key] = value; },
            parameter.meaning + " (" + accepted_text(parameter) + ")")
        ->type_name("");
  }
  command->add_option("--out", request->out,
                      "Folder for the files of the run (default: out, once files are asked for)");
  command
      ->add_option(
          "--every", request->every,
          "Write the files, and the rows of the CSV, every so many steps; without it the files at the end and about "
          "50 rows, at least 10 steps apart")
      ->check(whole_number(1, most_steps));
  command
      ->add_option("--format", request->formats,
                   "Files to write, with commas (default, once files are asked for: all but obj, ply, stl)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(output_formats()));
  command->add_option("--resume", request->resume, "Go on from a checkpoint, to --steps steps in all");
  command->add_option("--stats", request->stats, "Write the run's numbers to this JSON file");
  command->add_flag("--hash", request->hash, "Print the hash of the final state");
  command->add_flag("--quiet", request->quiet, "Print nothing but errors and the hash");
  add_instructions_option(*command);
  command->add_flag("--flux", request->flux, "Count the slabs lifted from each cell: the field \"flux\" of VTI files");
  CLI::Option* const frames =
      command
          ->add_option("--frames", request->frames,
                       "Draw a picture every so many steps, and join them to a film where ffmpeg is installed")
          ->check(whole_number(1, most_steps));
  // Without pictures they would do nothing.
  for (CLI::Option* option : add_picture_options(*command, *picture).get_options()) option->needs(frames);
  command->callback([&action, request, picture] {
    if (request->config.empty() && request->resume.empty()) throw CLI::RequiredError("CONFIG or --resume");
    action = [request, picture] { return run(*request, *picture); };
  });
}

}  // namespace erg::app
