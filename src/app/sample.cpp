#include "app/sample.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/presets.h"
#include "app/progress.h"
#include "app/text_table.h"
#include "io/config_file.h"

namespace erg {
namespace {

SeedRun run_once(const Config& config, const std::vector<std::int64_t>& watch) {
  Simulation simulation(config);
  MeasuredRun run(simulation, config.run.integer("steps"));
  SeedRun result;
  while (!run.finished()) {
    run.step();
    if (std::find(watch.begin(), watch.end(), simulation.step_count()) != watch.end()) {
      result.sd_at.emplace_back(simulation.step_count(), measure(simulation.terrain()).sd_slabs);
    }
  }
  result.end = run.statistics();
  return result;
}

}  // namespace

MeasuringNotice::MeasuringNotice(const std::vector<Config>& configs) : start_(std::chrono::steady_clock::now()) {
  const Config& first = configs.front();
  std::fprintf(stderr, "validate: %s, %s, %s ... ", first.title.c_str(), first.run.text("executor").c_str(),
               count_text(static_cast<int>(configs.size()), "seed").c_str());
}

MeasuringNotice::~MeasuringNotice() {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  std::fprintf(stderr, "%s\n", duration_text(elapsed.count()).c_str());
}

double Sample::mean() const {
  double sum = 0;
  for (const double value : values_) sum += value;
  return sum / static_cast<double>(values_.size());
}

double Sample::spread() const {
  if (values_.size() < 2) return 0;
  const double middle = mean();
  double squares = 0;
  for (const double value : values_) squares += (value - middle) * (value - middle);
  return std::sqrt(squares / static_cast<double>(values_.size() - 1));
}

std::string Sample::text(int digits) const {
  return fixed_text(mean(), digits) + " (" + fixed_text(spread(), digits) + ")";
}

Config thesis_config(const std::string& name) { return read_config(config_path("thesis/" + name)); }

std::vector<Config> seeded_configs(const Config& config, const std::string& executor, int seeds) {
  std::vector<Config> configs(static_cast<std::size_t>(seeds), config);
  for (int seed = 1; seed <= seeds; ++seed) {
    for (const std::string& setting :
         {"run.executor=" + executor, std::string("run.threads=1"), "run.seed=" + std::to_string(seed)}) {
      set_from_text(configs[static_cast<std::size_t>(seed - 1)], setting);
    }
  }
  return configs;
}

std::vector<SeedRun> run_seeds(const Config& config, const std::string& executor, int seeds,
                               const std::vector<std::int64_t>& watch) {
  return measure_each(seeded_configs(config, executor, seeds), [&](const Config& one) { return run_once(one, watch); });
}

}  // namespace erg
