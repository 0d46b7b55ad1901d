// Two to four setups beside each other under one wind, and how they differ.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "session/run_group.h"
#include "session/setup.h"
#include "session/snapshot.h"

namespace erg::session {

/// A value that is not the same in all setups.
struct SetupDifference {
  std::string name;                 ///< "parameters.p_sand", "model"
  std::string label;                ///< "Deposition on sand"
  std::vector<std::string> values;  ///< one for each setup, with units; "-" where the model has no such value
};

/// One number of all runs, for the table under the pictures.
struct ComparedNumber {
  io::RunNumber number;
  std::vector<double> values;  ///< one for each run; not-a-number where unknown
};

/// One to four setups. The wind of the first blows in all of them.
class Comparison {
 public:
  Comparison() : setups_(1) {}

  std::size_t size() const { return setups_.size(); }
  Setup& setup(std::size_t index) { return setups_.at(index); }
  const Setup& setup(std::size_t index) const { return setups_.at(index); }
  /// A copy of setup `index` at the end, with the seed after its own; returns its index. Nothing beyond most_runs.
  std::optional<std::size_t> add_copy_of(std::size_t index);
  /// Removes a setup; the last one stays. False then.
  bool remove(std::size_t index);
  /// One setup, this one.
  void set_only(Setup setup);

  /// Whether any of the models, which share one wind, uses this channel.
  bool uses(const forcing::Channel& channel) const;
  /// The wind of all.
  WindEditor wind() { return setups_.front().wind(); }

  std::vector<SetupDifference> differences() const;
  /// The config of one setup, with the one wind.
  sim::Config config(std::size_t index) const { return with_wind(setup(index).config()); }
  /// All of them.
  std::vector<sim::Config> configs() const;
  /// For Runner::change: the running configs with all that may take effect without a new terrain. The snapshot must
  /// have as many runs as there are setups.
  std::vector<sim::Config> configs_in_force(const Snapshot& snapshot) const;
  /// For Runner::create. Throws InputError with all mistakes, each with the number of its run.
  std::vector<sim::Config> configs_to_create();
  /// Whether CREATE is needed for what differs from the configs that run.
  bool needs_new_terrain(const Snapshot& snapshot) const;

 private:
  sim::Config with_wind(sim::Config config) const;

  std::vector<Setup> setups_;
};

/// The last numbers of all runs.
std::vector<ComparedNumber> compared_numbers(const Snapshot& snapshot);

}  // namespace erg::session
