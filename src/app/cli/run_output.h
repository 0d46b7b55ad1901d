// The files of a run: pictures, heightmaps, VTI, a CSV of its numbers, checkpoints.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "io/formats/run_numbers.h"
#include "io/formats/table.h"
#include "sim/simulation.h"

namespace erg::app {

/// What `--format` accepts.
const std::vector<std::string>& output_formats();
/// Those that are written when none is asked for: all but the meshes, which are large.
const std::vector<std::string>& usual_formats();

/// Writes the files of one run, which must outlive it.
class RunOutput {
 public:
  /// Writes into `folder` (made when missing) files whose names begin with `name`, in those `formats`. Tries all names
  /// before it writes anything; throws InputError where one of them cannot be written, or another run writes the table.
  RunOutput(std::filesystem::path folder, std::string name, std::vector<std::string> formats,
            sim::Simulation& simulation);

  /// Adds the present numbers to the CSV, if there is one. Lifts, polls and flux are those since the last row. Throws
  /// WriteError, as do the others.
  void add_row();
  /// Takes note of where the dunes stand, for the migration in the next row (RunMeter::glance).
  void glance();
  /// Writes the present state in every other format, the checkpoint first.
  void write_state();
  /// Writes a checkpoint, whatever the formats, unless that of this step is written; its path.
  std::filesystem::path write_state_checkpoint();

  /// The last checkpoint that was written; empty before the first.
  const std::filesystem::path& last_checkpoint() const { return last_checkpoint_; }
  /// The files written so far, in order.
  const std::vector<std::filesystem::path>& files() const { return files_; }

 private:
  bool wants(const std::string& format) const;
  void try_files() const;
  void write_meshes(const io::Provenance& source);
  /// The file of a step, and of the present one.
  std::filesystem::path numbered(std::int64_t step, const std::string& ending) const;
  std::filesystem::path numbered(const std::string& ending) const { return numbered(simulation_.step_count(), ending); }

  std::filesystem::path folder_;
  std::string name_;
  std::vector<std::string> formats_;
  sim::Simulation& simulation_;
  std::unique_ptr<io::TableFile> table_;
  io::RunMeter meter_;
  std::vector<std::filesystem::path> files_;
  std::filesystem::path last_checkpoint_;
};

}  // namespace erg::app
