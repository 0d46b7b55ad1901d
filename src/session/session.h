// The session saved every few minutes, and found again after a crash.
//
// Each running program has a folder of its own below the state folder: `session-PID` with a lock file that the program
// holds locked as long as it lives (the system unlocks it however the program ends), `session.json` and one checkpoint
// a run. A program that ends in order removes its folder. One that is there and not locked is a crash's.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "io/checkpoint/checkpoint.h"
#include "session/snapshot.h"

namespace erg::session {

/// What a crash left behind.
struct CrashedSession {
  std::filesystem::path folder;
  std::string title;     ///< of the first run
  std::string saved_at;  ///< "2026-03-01 14:05:12", local
  std::int64_t step = 0;
  std::size_t runs = 0;
};

/// The session of this program.
class Session {
 public:
  /// Makes this program's folder below `state_folder`. Throws InputError when that cannot be written.
  explicit Session(const std::filesystem::path& state_folder);
  /// Ends in order: waits for the save under way and removes the folder.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Saves in the background if `minutes` (0: never) have passed since the last save and anything changed. Call it
  /// often.
  void save_if_due(const std::shared_ptr<const Snapshot>& snapshot, double minutes);
  /// Saves now and waits. Throws InputError when it cannot.
  void save(const Snapshot& snapshot);
  /// Leaves the folder for the next start to find, as a crash would: for a display that is lost.
  void keep() { keep_ = true; }
  /// The runs of a lost session are this one's now: its folder goes as soon as this session has saved them itself.
  void replaces(const CrashedSession& session);
  /// What went wrong with the last background save; "" if nothing. Asking clears it.
  std::string take_problem();

  /// Sessions of programs that are gone, latest first. One whose session.json is missing or damaged is offered by
  /// its checkpoints; folders in which nothing was saved are removed.
  static std::vector<CrashedSession> lost(const std::filesystem::path& state_folder);
  /// The runs of one, for Runner::resume. Where session.json is missing or damaged, the checkpoints of the save with
  /// the highest number. Throws InputError for a damaged checkpoint, or where there is none.
  static std::vector<io::Saved> recover(const CrashedSession& session);
  /// Removes what a crash left.
  static void discard(const CrashedSession& session);

 private:
  std::filesystem::path folder_;
  int lock_ = -1;
  bool keep_ = false;
  std::vector<std::filesystem::path> replaced_;
  std::future<std::string> saving_;
  std::string problem_;
  std::chrono::steady_clock::time_point last_save_;
  std::uint64_t saved_version_ = 0;
};

}  // namespace erg::session
