// `erg bench`: options, and the figures as a table or JSON.
#include "app/bench/bench_command.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/bench/bench.h"
#include "app/bench/frame_bench.h"
#include "app/bench/grain_bench.h"
#include "app/bench/render_bench.h"
#include "app/cli/known_words.h"
#include "app/cli/measured_run.h"
#include "app/cli/options.h"
#include "app/cli/text_table.h"
#include "compute/executor.h"
#include "core/number_text.h"
#include "core/terrain.h"
#include "forcing/bearing.h"
#include "models/model.h"
#include "render/gl_context.h"
#include "sim/make_executor.h"

namespace erg::app {

using models::ModelType;

namespace {

std::string json_text(const std::vector<BenchRow>& rows, const std::vector<GrainBenchRow>& grain_rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchRow& row : rows) {
    nlohmann::ordered_json object;
    object["model"] = row.model;
    object["scene"] = row.scene;
    object["nx"] = row.nx;
    object["ny"] = row.ny;
    object["executor"] = row.executor;
    object["threads"] = row.threads;
    object["bearing"] = row.bearing;
    object["sweeps"] = row.sweeps > 0 ? nlohmann::ordered_json(row.sweeps) : nlohmann::ordered_json();
    object["polls_per_second"] = row.polls_per_second;
    object["of_plain_dunes"] = row.of_plain;
    object["times_serial"] = row.times_serial;
    object["state_hash"] = hash_text(row.hash);
    list.push_back(std::move(object));
  }
  for (const GrainBenchRow& row : grain_rows) {
    list.push_back({{"model", row.model},
                    {"nx", row.side},
                    {"ny", row.side},
                    {"executor", row.executor},
                    {"threads", row.threads},
                    {"polls_per_second", row.polls_per_second},
                    {"grain_steps_per_second", row.grain_steps_per_second},
                    {"grain_steps_per_cpu_second", row.grain_steps_per_cpu_second},
                    {"state_hash", hash_text(row.hash)}});
  }
  return list.dump(2) + "\n";
}

std::string table_text(const std::vector<BenchRow>& rows, const std::string& executor) {
  constexpr double million = 1e6;
  TextTable table;
  table.heading = {"model", "scene", "bearing", "K", "threads", "serial", executor, executor + " / serial", "of plain"};
  for (const BenchRow& row : rows) {
    if (row.sweeps == 0) continue;  // the serial figure stands beside each of the others
    table.rows.push_back({row.model, row.scene, fixed_text(row.bearing, 0), std::to_string(row.sweeps),
                          std::to_string(row.threads), fixed_text(row.serial_polls_per_second / million, 1),
                          fixed_text(row.polls_per_second / million, 1), fixed_text(row.times_serial, 1),
                          fixed_text(row.of_plain, 2)});
  }
  return table.aligned() + "\nMillion polls a second in the best of " + std::to_string(bench_turns) +
         " turns. Ratios are medians over the turns; of plain: to the same executor on the\nmodel's first scene.\n";
}

/// Takes the models of single grains out of those to measure and returns them. When none is named, all are measured.
std::vector<std::string> take_grain_models(BenchOptions& options) {
  std::vector<std::string> wanted = options.models;
  if (wanted.empty()) {
    for (const ModelType& type : models::catalogue()) wanted.push_back(type.info.key);
  }
  options.models.clear();
  std::vector<std::string> grain_models;
  for (const std::string& key : wanted)
    (models::find_model(key).info.moves_grains ? grain_models : options.models).push_back(key);
  return grain_models;
}

/// Times of pictures as a table.
std::string render_text(const std::vector<int>& grids, const std::string& context) {
  std::string renderer;
  const std::vector<RenderBenchRow> rows = run_render_bench(grids, context, renderer);
  TextTable table;
  table.heading = {"grid", "quality", "drawn", "first", "turned", "a tenth changed", "all changed", "triangles"};
  const auto both = [](const PictureTime& time) {
    return fixed_text(time.wall, 3) + " (" + fixed_text(time.processor, 3) + ")";
  };
  for (const RenderBenchRow& row : rows) {
    table.rows.push_back({std::to_string(row.grid), row.quality, row.drawn, both(row.first), both(row.turned),
                          both(row.tenth), both(row.all), std::to_string(row.triangles)});
  }
  return table.aligned() + "\nSeconds (in brackets: of the processor) for a picture of 1280 x 720 pixels, drawn by " +
         renderer + ".\n";
}

/// What frames take as a table.
std::string frames_text(const std::vector<int>& grids, const std::string& context) {
  std::string renderer;
  const std::vector<FrameBenchRow> rows = run_frame_bench(grids, context, renderer);
  TextTable table;
  table.heading = {"grid", "settling", "copying", "ranges", "reading", "comparing", "uploading", "whole"};
  for (const FrameBenchRow& row : rows) {
    table.rows.push_back({std::to_string(row.grid)});
    for (const double seconds :
         {row.settling, row.copying, row.ranges, row.reading, row.comparing, row.uploading, row.whole()}) {
      table.rows.back().push_back(fixed_text(1000 * seconds, 1));
    }
  }
  return table.aligned() + "\nMilliseconds of the processor from a step to the screen, without drawing, into " +
         renderer + ".\n";
}

/// Why this executor cannot be measured here; empty where it can.
std::string why_not(const std::string& executor) {
  const auto probe = sim::make_executor({.name = executor, .threads = 1});
  return probe->name() == executor ? std::string() : probe->take_notice();
}

}  // namespace

void add_bench_command(CLI::App& program, Action& action) {
  struct Options {
    BenchOptions bench;
    std::string bearing = "270";
    bool json = false;
    bool render = false;
    bool frames = false;
    std::string context = "auto";
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = program.add_subcommand("bench", "Measure the executors on developed dunes and snow");
  const CLI::Option* const grid = command->add_option("--grid", options->bench.grid, "Cells a side")
                                      ->capture_default_str()
                                      ->check(whole_number(16, largest_side));
  command->add_option("--model", options->bench.models, "Model to measure (may be repeated; default: all)");
  command->add_option("--executor", options->bench.executor, "Executor to measure beside serial: cpu or cuda")
      ->capture_default_str()
      ->check(one_of({"cpu", "cuda"}));
  command->add_option("--threads", options->bench.threads, "Threads, measured beside one (0: every processor)")
      ->check(whole_number(0, 256));
  command->add_option("--sweeps", options->bench.sweeps, "Sub-sweeps K (default: 8 and 16)")
      ->check(one_of({"2", "4", "8", "16", "32", "64"}));
  command->add_option("--bearing", options->bearing, "Where the wind blows from: degrees or W, NW ...")
      ->capture_default_str();
  CLI::Option* const json = command->add_flag("--json", options->json, "Print a JSON list of rows");
  CLI::Option* const render =
      command
          ->add_flag("--render", options->render,
                     "Measure pictures instead, of --grid or else of 256, 1024 and 4096 cells a side")
          ->excludes(json);
  command
      ->add_flag("--frames", options->frames,
                 "Measure what brings a step to the screen instead, without drawing, on the same grids as --render")
      ->excludes(json)
      ->excludes(render);
  const CLI::Option* const context =
      command->add_option("--context", options->context, "What draws with --render and --frames: auto, egl, osmesa")
          ->capture_default_str()
          ->check(one_of(render::offscreen_kinds()));
  add_instructions_option(*command);
  command->callback([&action, options, grid, context] {
    const bool one_grid = grid->count() > 0;
    const bool draws = options->render || options->frames;
    if (context->count() > 0 && !draws) {
      throw InputError("--context", "says what draws, and nothing is drawn", "add --render or --frames");
    }
    action = [options, one_grid, draws] {
      if (draws) {
        const std::vector<int> grids =
            one_grid ? std::vector<int>{options->bench.grid} : std::vector<int>{256, 1024, 4096};
        std::cout << (options->render ? render_text : frames_text)(grids, options->context);
        return exit_done;
      }
      if (const std::string why = why_not(options->bench.executor); !why.empty()) {
        std::cout << "skipped: " << why << "\n";
        return exit_done;
      }
      options->bench.bearing = forcing::parse_bearing(options->bearing, "--bearing");
      const std::vector<std::string> grain_models = take_grain_models(options->bench);
      const bool slabs = !options->bench.models.empty();
      const std::vector<BenchRow> rows = slabs ? run_bench(options->bench) : std::vector<BenchRow>{};
      std::vector<GrainBenchRow> grain_rows;
      for (const std::string& model : grain_models) {
        for (GrainBenchRow& row : bench_grains(model, options->bench)) grain_rows.push_back(std::move(row));
      }
      if (options->json) {
        std::cout << json_text(rows, grain_rows);
      } else {
        std::cout << (slabs ? table_text(rows, options->bench.executor) : "")
                  << (slabs && !grain_rows.empty() ? "\n" : "") << (grain_rows.empty() ? "" : grains_table(grain_rows));
      }
      return exit_done;
    };
  });
}

}  // namespace erg::app
