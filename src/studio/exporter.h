// Writing files in the background, with progress and a way to stop.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "studio/snapshot.h"

namespace erg {

/// A kind of file that a run can be written as.
struct ExportFormat {
  std::string key;      ///< "png16"
  std::string label;    ///< "Heightmap (16-bit PNG)"
  std::string ending;   ///< ".png"
  std::string meaning;  ///< what it holds and what reads it
};
/// All of them, in the order people should meet them.
const std::vector<ExportFormat>& export_formats();

/// Writes one run of a snapshot. Throws InputError. `go_on` is told the part done, 0 to 1; when it says false the
/// writing stops with StoppedExport and leaves no file.
void export_run(const std::filesystem::path& path, const std::string& format, const RunSnapshot& run,
                const std::function<bool(double)>& go_on);

/// The writing was stopped.
struct StoppedExport {};

/// One export at work on a thread of its own.
class Export {
 public:
  enum class State { writing, done, stopped, failed };

  Export(std::filesystem::path path, std::string format, std::shared_ptr<const Snapshot> snapshot, std::size_t run);
  /// Stops it and waits.
  ~Export();

  const std::filesystem::path& path() const { return path_; }
  double progress() const { return progress_; }
  State state() const { return state_; }
  /// Why it failed; read it when the state is `failed`.
  const std::string& problem() const { return problem_; }
  void stop() { stop_ = true; }

 private:
  std::filesystem::path path_;
  std::string problem_;
  std::atomic<double> progress_{0};
  std::atomic<bool> stop_{false};
  std::atomic<State> state_{State::writing};
  std::thread thread_;
};

}  // namespace erg
