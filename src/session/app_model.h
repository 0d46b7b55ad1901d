// Everything the window shows and does, without a window: what a panel gets to see.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "session/comparison.h"
#include "session/exporter.h"
#include "session/log.h"
#include "session/probe.h"
#include "session/runner.h"
#include "session/session.h"
#include "session/settings.h"
#include "session/snapshot.h"
#include "session/unsaved_work.h"

namespace erg::session {

/// Where things are kept. An empty folder: nothing is kept.
struct AppFolders {
  std::filesystem::path settings;  ///< what is remembered of the window (settings_folder)
  std::filesystem::path state;     ///< sessions (state_folder)
  std::filesystem::path presets;   ///< configs to start from; only read
};

/// The view model. Belongs to the window's thread.
class AppModel {
 public:
  /// `before_step` as for Runner.
  explicit AppModel(AppFolders folders, std::function<void()> before_step = {});
  /// Saves settings and ends the session in order.
  ~AppModel();
  AppModel(const AppModel&) = delete;
  AppModel& operator=(const AppModel&) = delete;

  /// Once a frame: takes the newest snapshot, hands edits that may take effect at once to the runs, autosaves.
  void tick();
  /// The snapshot that this frame draws; the same from tick to tick.
  const Snapshot& now() const { return *snapshot_; }

  Runner& runner() { return *runner_; }
  Comparison& comparison() { return comparison_; }
  /// The setup that the panels edit.
  Setup& setup() { return comparison_.setup(active_); }
  /// Its place in the comparison.
  std::size_t active() const { return active_; }
  /// Another one; nothing where there is no such setup.
  void set_active(std::size_t run);
  Log& log() { return log_; }
  Settings& settings() { return settings_; }
  const AppFolders& folders() const { return folders_; }

  /// CREATE. False, with the mistakes in the log, when something stands against it.
  bool create();
  /// Whether CREATE would change what runs (it lights up), or nothing runs yet.
  bool create_needed() const;

  /// Whether terrains that were asked for (created, opened, recovered) could not be made after all, since this was last
  /// asked; the log says why.
  bool take_failed_creation() { return std::exchange(creation_failed_, false); }

  /// Opens a config (or a checkpoint) and creates it. A file with mistakes is refused: every mistake goes to the log
  /// with its line, and what was open stays. So does it when the terrain cannot be made; that shows at a later tick.
  bool open(const std::filesystem::path& path);
  /// The same, and lets it run as soon as it is made.
  bool open_and_play(const std::filesystem::path& path);
  /// Saves the setup as a config. False, with the reason in the log, when it cannot.
  bool save_config(const std::filesystem::path& path);
  /// The file that the setup came from or was saved to; empty at first.
  const std::filesystem::path& file() const { return file_; }
  /// Whether `file` is a config of the person's own that Save writes anew. Presets are there to start from.
  bool has_own_file() const;
  /// A name for a file about the active run, from its file or title.
  std::string suggested_name(const std::string& ending) const;
  /// The active setup stands in no file.
  bool unsaved() const;
  /// What would be lost if this were left behind now.
  std::optional<UnsavedItem> unsaved_work(Leaves leaves) const;
  /// "Barchan field - Momiji et al. 2000, 512 x 512".
  std::string title() const;

  /// The place in the snapshot of the run that panels show: the active setup's, or the last one while a run just added
  /// is not made yet. Means something only while there are runs.
  std::size_t shown() const { return std::min(active_, snapshot_->runs.size() - 1); }
  /// That run; null before there is any.
  const RunSnapshot* active_run() const;
  /// Starts an export of the active run (export_formats(); a checkpoint is one of them). Stops the one before.
  void start_export(const std::filesystem::path& path, const std::string& format);
  /// The export under way or just ended; null when there was none.
  Export* running_export() { return export_.get(); }
  /// Where a file about the active run says it comes from.
  io::Provenance provenance() const;

  /// Sessions that a crash left behind. One stays until its runs are made anew, or it is discarded.
  const std::vector<CrashedSession>& crashed_sessions() const { return lost_; }
  /// Goes on with the lost session of this folder; false, with the reason in the log, when it cannot be read. When its
  /// runs cannot be made, what was open stays, and the session stays on offer; that shows at a later tick.
  bool recover(const std::filesystem::path& folder);
  /// Deletes the lost session of this folder; nothing where there is none.
  void discard_crashed(const std::filesystem::path& folder);
  /// Why no session is saved, and what to do about it; "" where one is.
  std::string why_not_kept() const;
  /// The program has to end: saves the runs for the next start. What to tell the person: where, or why not.
  std::string rescue();

 private:
  void hand_over(std::vector<sim::Config> configs);
  void await_creation();
  void take_over_creation();
  void apply_edits();
  void watch_export();
  void take_over_crashed();
  void show(Comparison comparison, const std::filesystem::path& file);
  void resume(std::vector<io::Saved> saved, const std::filesystem::path& file);
  void keep_settings();
  void remember_file();

  /// What was open, to go back to when what is opened cannot be made.
  struct Before {
    Comparison comparison;
    std::size_t active = 0;
    std::filesystem::path file;
    UnsavedItem kept;
  };

  AppFolders folders_;
  Log log_;
  Settings settings_;
  Settings kept_settings_;  // as they stand in the file
  Comparison comparison_;
  std::size_t active_ = 0;
  std::filesystem::path file_;
  UnsavedItem kept_;
  std::vector<sim::Config> handed_over_;  // what the runner was last given
  std::uint64_t creation_awaited_ = 0;    // the number of the command that makes what was asked for; 0: it is there
  std::optional<Before> before_opening_;
  std::optional<CrashedSession> recovering_;  // until its runs are made
  bool play_when_made_ = false;
  bool creation_failed_ = false;
  std::unique_ptr<Runner> runner_;
  std::shared_ptr<const Snapshot> snapshot_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<Export> export_;
  bool export_reported_ = true;
  std::shared_ptr<const Snapshot> exported_;  // what the file under way keeps something of; else null
  std::size_t exported_run_ = 0;
  Keeps exported_keeps_ = Keeps::nothing;
  std::vector<CrashedSession> lost_;
};

}  // namespace erg::session
