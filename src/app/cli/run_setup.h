// From what the command line asks for to a simulation that is ready to step.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sim/simulation.h"

namespace erg::app {

/// What `erg run` was asked for.
struct RunRequest {
  std::string config;                          ///< file or preset; may be empty when `resume` is given
  std::vector<std::string> assignments;        ///< of --set, in order
  std::map<std::string, std::string> options;  ///< run parameters with an option of their own: "--steps" and its value
  std::string resume;                          ///< checkpoint
  std::string out;                             ///< folder; empty: not given
  std::vector<std::string> formats;            ///< empty: not given
  std::int64_t every = 0;                      ///< steps between outputs; 0: at the end only
  std::int64_t frames = 0;                     ///< steps between the pictures of a film; 0: none
  bool flux = false;                           ///< .vti files hold the field "flux"
  std::string stats;                           ///< file; empty: none
  bool hash = false;
  bool quiet = false;
};

/// The simulation that the request describes, at its first step or where its checkpoint stands. Throws InputError with
/// all mistakes of config and options.
sim::Simulation start_simulation(const RunRequest& request);

/// Whether what a command was given is a checkpoint, by its name's ending; else it is a config or a preset.
bool is_checkpoint(const std::string& source);

/// The same for commands that take a config, a preset or a checkpoint, with the assignments of --set.
sim::Simulation start_from(const std::string& source, const std::vector<std::string>& assignments);

/// Whether files are written while it runs.
bool writes_files(const RunRequest& request);
/// The folder of its files: the one asked for, or the usual one.
std::string output_folder(const RunRequest& request);
/// A name for the run's files: that of its config or checkpoint.
std::string run_name(const RunRequest& request);

}  // namespace erg::app
