// Where a file came from. Every file that leaves the program says so in its own way, with the same words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sim/config.h"

namespace erg::io {

/// All that it takes to make a file again.
struct Provenance {
  std::string config;  ///< the run's whole config, as JSON text
  std::uint64_t seed = 0;
  std::int64_t step = 0;  ///< steps done
  std::string model;      ///< key in the catalogue
  std::string version;    ///< of the program
  std::string executor;   ///< "cpu, 2 threads"
  /// Days of the world since step 0 (sim/step_time.h); not-a-number where steps have no time of their own.
  double days = std::numeric_limits<double>::quiet_NaN();
};

/// The version of this program.
std::string program_version();

/// "cpu, 2 threads".
std::string executor_text(const std::string& executor, int threads);

/// The provenance of a run of this config after `step` steps.
Provenance provenance_of(const sim::Config& config, std::int64_t step, const std::string& executor, int threads);

/// Names and texts to write into a file, in order.
using MetadataEntries = std::vector<std::pair<std::string, std::string>>;

/// A config of at most so many bytes stands whole in every file about its run. A longer one (a wind of thousands of
/// seasons) is written once, beside them.
inline constexpr std::size_t longest_config_within = 4096;

/// 16 hexadecimal digits that tell one config from another.
std::string config_hash(const Provenance& provenance);

/// The provenance as entries, for what is printed: "erg:version", "erg:model", "erg:seed", "erg:step", "erg:executor",
/// "erg:config-hash", "erg:config", and "erg:days" where it is known.
MetadataEntries metadata(const Provenance& provenance);

/// The same for the file `path`. A config that is too long to stand in it is written beside it, unless it lies there
/// already, and "erg:config-file" with that file's name stands for "erg:config"; but nothing lies beside a pipe or a
/// device, which gets it whole. A PNG carries the entries as text chunks, a VTI as field data of strings, a CSV as
/// comment lines before its header. Throws WriteError.
MetadataEntries metadata_of_file(const std::filesystem::path& path, const Provenance& provenance);

}  // namespace erg::io
