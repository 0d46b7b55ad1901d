// Runs of one config with several seeds, and the mean and spread of their numbers.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/measured_run.h"
#include "sim/config.h"

namespace erg {

/// A number that was measured once for each seed.
class Sample {
 public:
  void add(double value) { values_.push_back(value); }
  bool empty() const { return values_.empty(); }
  double mean() const;
  /// Standard deviation over the seeds; 0 for one seed.
  double spread() const;
  /// "4.25 (.17)": mean and spread.
  std::string text(int digits) const;

 private:
  std::vector<double> values_;
};

/// One run with its numbers at the end, and the standard deviation of height (slabs) at some steps on the way.
struct SeedRun {
  RunStatistics end;
  std::vector<std::pair<std::int64_t, double>> sd_at;
};

/// "validate: TITLE, cpu, 3 seeds ... 12 s" on standard error: begins the line, and ends it when it goes.
class MeasuringNotice {
 public:
  explicit MeasuringNotice(const std::vector<Config>& configs);
  ~MeasuringNotice();
  MeasuringNotice(const MeasuringNotice&) = delete;
  MeasuringNotice& operator=(const MeasuringNotice&) = delete;

 private:
  std::chrono::steady_clock::time_point start_;
};

/// The config of the preset cfg/thesis/NAME.json. Throws InputError when it is not there.
Config thesis_config(const std::string& name);

/// `config` for `executor`, with each of the seeds 1 to `seeds` and one thread for each run.
std::vector<Config> seeded_configs(const Config& config, const std::string& executor, int seeds);

/// What `measure` returns for each config, in their order. As many go side by side as there are processors, since none
/// of them waits for another. Says on standard error what it is at: the first config's title.
template <typename Measure>
auto measure_each(const std::vector<Config>& configs, const Measure& measure) {
  using Result = decltype(measure(configs.front()));
  const MeasuringNotice notice(configs);
  const std::size_t side_by_side = std::max(1u, std::thread::hardware_concurrency());
  std::vector<Result> results;
  for (std::size_t first = 0; first < configs.size(); first += side_by_side) {
    std::vector<std::future<Result>> batch;
    for (std::size_t k = first; k < std::min(first + side_by_side, configs.size()); ++k) {
      batch.push_back(std::async(std::launch::async, [&measure, &config = configs[k]] { return measure(config); }));
    }
    for (std::future<Result>& run : batch) results.push_back(run.get());
  }
  return results;
}

/// Runs `config` on `executor` with seeds 1 to `seeds`, each to the config's last step; the runs share the
/// processors. `watch`: steps at which to measure the standard deviation of height.
std::vector<SeedRun> run_seeds(const Config& config, const std::string& executor, int seeds,
                               const std::vector<std::int64_t>& watch = {});

/// Collects one number of every run.
template <typename Number>
Sample sample_of(const std::vector<SeedRun>& runs, Number number) {
  Sample sample;
  for (const SeedRun& run : runs) sample.add(number(run));
  return sample;
}

}  // namespace erg
