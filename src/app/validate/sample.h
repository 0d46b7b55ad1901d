// Runs of one config with several seeds, and the mean and spread of their numbers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/measured_run.h"
#include "sim/config.h"

namespace erg::app {

/// Calls `job` with 0 to `jobs` - 1, as many at a time as there are processors. A job should run on one thread: then
/// none waits for another. Rethrows what a job throws.
void share_jobs(int jobs, const std::function<void(int)>& job);

/// What `job` returns for 0 to `jobs` - 1, in this order.
template <typename Result, typename Job>
std::vector<Result> side_by_side(int jobs, const Job& job) {
  std::vector<Result> results(static_cast<std::size_t>(jobs));
  share_jobs(jobs, [&](int at) { results[static_cast<std::size_t>(at)] = job(at); });
  return results;
}

/// A number that was measured once for each seed.
class Sample {
 public:
  void add(double value) { values_.push_back(value); }
  int count() const { return static_cast<int>(values_.size()); }
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

/// The config of the preset cfg/thesis/NAME.json. Throws InputError when it is not there.
sim::Config thesis_config(const std::string& name);

/// Runs `config` on `executor` with seeds 1 to `seeds`, each to the config's last step; the runs share the
/// processors. `watch`: steps at which to measure the standard deviation of height.
std::vector<SeedRun> run_seeds(const sim::Config& config, const std::string& executor, int seeds,
                               const std::vector<std::int64_t>& watch = {});

/// Collects one number of every run.
template <typename Number>
Sample sample_of(const std::vector<SeedRun>& runs, Number number) {
  Sample sample;
  for (const SeedRun& run : runs) sample.add(number(run));
  return sample;
}

}  // namespace erg::app
