// `erg measure`: the dunes of a config's terrain or of a checkpoint, one by one and together.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/dune_tables.h"
#include "app/cli/dune_watch.h"
#include "app/cli/interrupt.h"
#include "app/cli/notice.h"
#include "app/cli/progress.h"
#include "app/cli/run_setup.h"
#include "core/errors.h"
#include "forcing/bearing.h"
#include "io/checkpoint/start_simulation.h"

namespace erg::app {

using io::MeasuredDunes;
using sim::Simulation;

namespace {

struct MeasureRequest {
  std::string source;  ///< config, preset or checkpoint
  std::vector<std::string> assignments;
  std::int64_t steps = -1;  ///< -1: a config's own number; a checkpoint as it is
  std::int64_t every = 0;   ///< steps from moment to moment; 0: the last step only
  DuneWatchOptions watch;
  bool json = false;
  bool csv = false;
  bool summary = false;
  bool quiet = false;
};

std::int64_t last_step(const MeasureRequest& request, const Simulation& simulation) {
  if (request.steps < 0) {
    return is_checkpoint(request.source) ? simulation.step_count() : simulation.config().run.integer("steps");
  }
  if (request.steps >= simulation.step_count()) return request.steps;
  throw InputError("--steps " + std::to_string(request.steps),
                   "the checkpoint stands at step " + std::to_string(simulation.step_count()) + " already",
                   "ask for that step or a later one");
}

/// The next step at which to measure.
std::int64_t next_moment(const MeasureRequest& request, std::int64_t step, std::int64_t last) {
  if (request.every == 0) return last;
  return std::min(last, (step / request.every + 1) * request.every);
}

/// Runs and measures; false when interrupted.
bool watch(const MeasureRequest& request, Simulation& simulation, std::vector<MeasuredDunes>& moments) {
  const std::int64_t last = last_step(request, simulation);
  DuneWatchOptions options = request.watch;
  if (request.every > 0) options.follow = std::min(options.follow, request.every);
  DuneWatch dunes(simulation, options);
  print_notice(simulation.executor());
  Progress progress(progress_style(request.quiet), simulation.model_type().info.title, simulation.step_count(), last);
  const InterruptGuard guard;
  // A moment is measured with the steps that follow it, so a later one may be due at once.
  std::int64_t due = request.every > 0 ? simulation.step_count() : last;
  while (true) {
    while (simulation.step_count() < due && !simulation.finished()) {
      if (InterruptGuard::interrupted()) return false;
      dunes.step();
      print_notice(simulation.executor());
      progress.update(simulation.step_count(), simulation.totals().polls);
    }
    moments.push_back(dunes.measure());
    if (due >= last || simulation.finished()) return true;
    due = next_moment(request, due, last);
  }
}

ExitCode measure_source(const MeasureRequest& request) {
  Simulation simulation = start_from(request.source, request.assignments);
  std::vector<MeasuredDunes> moments;
  const io::Provenance source = io::provenance_of(simulation);
  if (!watch(request, simulation, moments)) {
    std::cerr << "Interrupted after step " << simulation.step_count() << "; nothing was measured.\n";
    return exit_failed;
  }
  if (request.json) {
    std::cout << dunes_json(moments, simulation.config());
  } else if (request.csv) {
    std::cout << (request.summary ? fields_csv(moments, source) : dunes_csv(moments, source));
  } else {
    std::cout << (request.summary || moments.size() > 1 ? fields_text(moments) : dunes_text(moments.front()));
  }
  return exit_done;
}

}  // namespace

void add_measure_command(CLI::App& program, Action& action) {
  const auto request = std::make_shared<MeasureRequest>();
  CLI::App* command = program.add_subcommand("measure", "Measure the dunes of a run, each and together");
  command->add_option("SOURCE", request->source, "Config file, name of a preset, or checkpoint")->required();
  command->add_option("--set", request->assignments, "Change one value of the config: key=value or group.key=value")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  command->add_option("--steps", request->steps, "Step to measure (default: a config's last step; a checkpoint's own)")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--every", request->every, "Measure every so many steps from the start on, and the last")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--follow", request->watch.follow,
                   "Follow the dunes over so many further steps for their speed (20; 0: not)")
      ->check(CLI::Range(0, 100000));
  command
      ->add_option("--least", request->watch.least,
                   "Slabs of sand from which on a cell belongs to a dune (default: more than the mean, and than the "
                   "sand between dunes by 3)")
      ->check(CLI::PositiveNumber);
  command->add_option("--smallest", request->watch.smallest, "Cells from which on a patch of such sand is a dune (30)")
      ->check(CLI::PositiveNumber);
  command->add_option_function<std::string>(
      "--bearing",
      [request](const std::string& text) { request->watch.bearing = forcing::parse_bearing(text, "--bearing"); },
      "Measure along a wind from this bearing (default: where the config's wind comes from on the mean)");
  CLI::Option* const json = command->add_flag("--json", request->json, "Print everything as JSON");
  CLI::Option* const csv = command->add_flag("--csv", request->csv, "Print a row for each dune and moment as CSV");
  csv->excludes(json);
  command->add_flag("--summary", request->summary, "Print a row for each moment, of all its dunes together")
      ->excludes(json);
  command->add_flag("--quiet", request->quiet, "Show no progress");
  command->callback([&action, request] { action = [request] { return measure_source(*request); }; });
}

}  // namespace erg::app
