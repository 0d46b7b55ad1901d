// Writing files in the background, with progress and a way to stop.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "io/formats/mesh.h"
#include "session/snapshot.h"

namespace erg::session {

/// What of a run can be had again from a file.
enum class Keeps {
  nothing,
  setup,   ///< the config
  terrain  ///< everything, the config too
};

/// A kind of file that a run can be written as.
struct ExportFormat {
  std::string key;      ///< "png16"
  std::string label;    ///< "Heightmap (16-bit PNG)"
  std::string ending;   ///< ".png"
  std::string meaning;  ///< what it holds and what reads it
  Keeps keeps = Keeps::nothing;
  std::string suffix = {};  ///< of the name that is proposed, where another format has the same ending
};
/// All of them, in the order people should meet them.
const std::vector<ExportFormat>& export_formats();
/// What a file of the format with this key keeps; nothing where there is no such format.
Keeps kept_by(const std::string& format);

/// Writes one run of a snapshot in the format of this key. Throws InputError, or StoppedWriting when `progress` says to
/// stop; then no file is left.
void export_run(const std::filesystem::path& path, const std::string& format, const RunSnapshot& run,
                const io::WriteProgress& progress);

/// One export at work on a thread of its own.
class Export {
 public:
  enum class State { writing, done, stopped, failed };

  /// `run`: index into the snapshot's runs, which must have it.
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
  void write(const std::string& format, const RunSnapshot& run);

  std::filesystem::path path_;
  std::string problem_;
  std::atomic<double> progress_{0};
  std::atomic<bool> stop_{false};
  std::atomic<State> state_{State::writing};
  std::thread thread_;
};

}  // namespace erg::session
