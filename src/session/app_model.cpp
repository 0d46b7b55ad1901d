#include "session/app_model.h"

#include <utility>

#include "core/errors.h"
#include "io/config/config_file.h"
#include "io/files/given_file.h"
#include "sim/memory.h"

namespace erg::session {

using io::provenance_of;
using sim::Config;
using sim::problem_of;

namespace {

namespace fs = std::filesystem;

/// Does something that files may spoil; what goes wrong goes to the log.
template <typename Work>
bool logged(Log& log, const Work& work) {
  try {
    work();
    return true;
  } catch (const InputError& error) {
    log.mistakes(error);
  } catch (const std::exception& error) {
    log.error(problem_of(error));
  }
  return false;
}

bool is_below(const fs::path& file, const fs::path& folder) {
  if (folder.empty()) return false;
  std::error_code ignored;
  const fs::path way = fs::relative(file, folder, ignored);
  return !way.empty() && *way.begin() != "..";
}

}  // namespace

AppModel::AppModel(AppFolders folders, std::function<void()> before_step) : folders_(std::move(folders)) {
  std::string complaint;
  if (!folders_.settings.empty()) settings_ = read_settings(folders_.settings, complaint);
  if (!complaint.empty()) log_.warning(complaint);
  kept_settings_ = settings_;
  if (!folders_.state.empty()) {
    lost_ = Session::lost(folders_.state);
    logged(log_, [this] { session_ = std::make_unique<Session>(folders_.state); });
  }
  kept_.start_from({}, comparison_.config(0));
  runner_ = std::make_unique<Runner>(log_, std::move(before_step));
  snapshot_ = runner_->snapshot();
}

AppModel::~AppModel() { keep_settings(); }

void AppModel::keep_settings() {
  if (folders_.settings.empty() || settings_ == kept_settings_) return;
  if (logged(log_, [this] { write_settings(folders_.settings, settings_); })) kept_settings_ = settings_;
}

void AppModel::tick() {
  const Activity before = snapshot_->activity;
  snapshot_ = runner_->snapshot();
  take_over_creation();
  apply_edits();
  watch_export();
  if (session_ == nullptr) return;
  const bool failed_now = snapshot_->activity == Activity::failed && before != Activity::failed;
  if (failed_now) {
    logged(log_, [this] {
      session_->save(*snapshot_);
      log_.information("the terrain is saved in " + session_->folder().string());
    });
  }
  session_->save_if_due(snapshot_, settings_.autosave_minutes);
  if (const std::string problem = session_->take_problem(); !problem.empty()) {
    log_.warning("the session could not be saved: " + problem);
  }
}

void AppModel::set_active(std::size_t run) {
  if (run < comparison_.size()) active_ = run;
}

// -- creating, and edits while a run goes on --

bool AppModel::create() {
  return logged(log_, [this] { hand_over(comparison_.configs_to_create()); });
}

void AppModel::hand_over(std::vector<Config> configs) {
  handed_over_ = configs;
  runner_->create(std::move(configs));
  await_creation();
}

/// What was asked for before is not waited for any more.
void AppModel::await_creation() {
  creation_awaited_ = runner_->commands_given();
  recovering_.reset();
  play_when_made_ = false;
}

bool AppModel::create_needed() const { return comparison_.needs_new_terrain(*snapshot_); }

/// Looks whether what was asked for is there by now: until then the runs are not those that the setups speak of.
void AppModel::take_over_creation() {
  if (creation_awaited_ == 0 || snapshot_->commands_done < creation_awaited_) return;
  const bool made = snapshot_->failed_creation != creation_awaited_;
  creation_awaited_ = 0;
  creation_failed_ = creation_failed_ || !made;
  if (before_opening_ && !made) {
    comparison_ = std::move(before_opening_->comparison);
    active_ = before_opening_->active;
    file_ = std::move(before_opening_->file);
    kept_ = std::move(before_opening_->kept);
    handed_over_.clear();
  } else if (before_opening_ && !file_.empty()) {
    log_.information("opened " + file_.string());
    remember_file();
  }
  if (made && recovering_) take_over_crashed();
  if (made && play_when_made_) runner_->play();
  recovering_.reset();
  play_when_made_ = false;
  before_opening_.reset();
}

/// The runs of the session that a crash left are there: it is not needed any more once they are saved again.
void AppModel::take_over_crashed() {
  kept_.recovered(*snapshot_);
  std::erase_if(lost_, [this](const CrashedSession& lost) { return lost.folder == recovering_->folder; });
  if (session_ != nullptr) session_->replaces(*recovering_);
  log_.information("recovered the session of " + recovering_->saved_at);
}

void AppModel::apply_edits() {
  if (creation_awaited_ > 0 || snapshot_->runs.size() != comparison_.size()) return;
  std::vector<Config> wanted = comparison_.configs_in_force(*snapshot_);
  if (wanted == handed_over_) return;
  handed_over_ = wanted;
  runner_->change(std::move(wanted));
}

// -- files --

bool AppModel::open(const fs::path& path) {
  return logged(log_, [&] {
    if (path.extension() == ".checkpoint") {
      resume({io::read_checkpoint(path)}, path);
    } else {
      Comparison opened;
      std::vector<std::string> notes;
      opened.set_only(Setup(io::read_config(path, &notes)));
      for (const std::string& note : notes) log_.information(note);
      std::vector<Config> configs = opened.configs_to_create();
      show(std::move(opened), path);
      hand_over(std::move(configs));
    }
  });
}

bool AppModel::open_and_play(const fs::path& path) {
  if (!open(path)) return false;
  play_when_made_ = true;
  return true;
}

/// Other setups than before; what was there is kept until the runs are made.
void AppModel::show(Comparison comparison, const fs::path& file) {
  if (!before_opening_) before_opening_ = Before{comparison_, active_, file_, kept_};
  comparison_ = std::move(comparison);
  active_ = 0;
  file_ = file;
  kept_.start_from(file_, comparison_.config(0));
}

void AppModel::resume(std::vector<io::Saved> saved, const fs::path& file) {
  Comparison resumed;
  for (std::size_t i = 0; i < saved.size(); ++i) {
    if (i > 0) resumed.add_copy_of(0);
    resumed.setup(i).replace(saved[i].config);
  }
  show(std::move(resumed), file);
  handed_over_ = comparison_.configs();
  runner_->resume(std::move(saved));
  await_creation();
}

bool AppModel::save_config(const fs::path& path) {
  return logged(log_, [&] {
    Config config = comparison_.config(active_);
    io::write_config(path, config);
    comparison_.setup(active_).set_title(config.title);  // it and the file speak of this model from now on
    kept_.setup_saved(path, std::move(config));
    file_ = path;
    remember_file();
    log_.information("saved " + path.string());
  });
}

void AppModel::remember_file() {
  if (io::is_stream(file_)) return;
  settings_.add_recent(file_);
  settings_.last_folder = fs::absolute(file_).parent_path().string();
}

bool AppModel::has_own_file() const {
  return file_.extension() == ".json" && comparison_.size() == 1 && !is_below(file_, folders_.presets);
}

std::string AppModel::suggested_name(const std::string& ending) const {
  const Setup& setup = comparison_.setup(active_);
  if (!file_.empty()) return (setup.has_its_own_model() ? file_.stem().string() : setup.config().model) + ending;
  std::string name;
  for (const char letter : setup.config().title) {
    const bool plain = (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
    const bool capital = letter >= 'A' && letter <= 'Z';
    const bool of_another_script = (static_cast<unsigned char>(letter) & 0x80) != 0;  // a part of it, in UTF-8
    if (plain || capital || of_another_script) {
      name += capital ? static_cast<char>(letter - 'A' + 'a') : letter;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  return (name.empty() ? "dunes" : name) + ending;
}

bool AppModel::unsaved() const { return !kept_.has(comparison_.config(active_)); }

std::optional<UnsavedItem> AppModel::unsaved_work(Leaves leaves) const {
  return kept_.missing(comparison_, *snapshot_, leaves);
}

std::string AppModel::title() const {
  const Config& config = comparison_.setup(active_).config();
  const bool of_file = !file_.empty() && comparison_.setup(active_).has_its_own_model();
  const std::string name = !config.title.empty() ? config.title : of_file ? file_.stem().string() : "untitled";
  return name + " - " + comparison_.setup(active_).model().info.title + ", " +
         std::to_string(config.grid.integer("nx")) + " x " + std::to_string(config.grid.integer("ny"));
}

const RunSnapshot* AppModel::active_run() const { return snapshot_->has_runs() ? &snapshot_->runs[shown()] : nullptr; }

void AppModel::start_export(const fs::path& path, const std::string& format) {
  if (active_run() == nullptr) {
    log_.error("there is nothing to export: create a terrain first");
    return;
  }
  export_.reset();  // one at a time: stops the one before
  logged(log_, [&] {
    export_ = std::make_unique<Export>(path, format, snapshot_, shown());
    exported_keeps_ = kept_by(format);
    exported_ = exported_keeps_ != Keeps::nothing ? snapshot_ : nullptr;
    exported_run_ = shown();
    export_reported_ = false;
  });
}

void AppModel::watch_export() {
  if (export_ == nullptr || export_reported_ || export_->state() == Export::State::writing) return;
  export_reported_ = true;
  if (export_->state() == Export::State::done) {
    log_.information("wrote " + export_->path().string());
    if (exported_keeps_ == Keeps::terrain) kept_.terrain_saved(*exported_, exported_run_);
    if (exported_keeps_ != Keeps::nothing) {
      kept_.setup_saved(export_->path(), *exported_->runs[exported_run_].config);
    }
  }
  if (export_->state() == Export::State::stopped) log_.warning("stopped writing " + export_->path().string());
  if (export_->state() == Export::State::failed) log_.error(export_->problem());
  exported_.reset();  // it holds the terrains of all runs
}

io::Provenance AppModel::provenance() const {
  const RunSnapshot* run = active_run();
  if (run == nullptr) return provenance_of(comparison_.setup(active_).config(), 0, "none", 0);
  return provenance_of(*run->config, run->step, run->executor, run->threads);
}

// -- after a crash --

bool AppModel::recover(const fs::path& folder) {
  const auto found = std::ranges::find(lost_, folder, &CrashedSession::folder);
  if (found == lost_.end()) {
    log_.error("nothing is left to recover in " + folder.string());
    return false;
  }
  return logged(log_, [&] {
    resume(Session::recover(*found), {});
    recovering_ = *found;
  });
}

void AppModel::discard_crashed(const fs::path& folder) {
  const auto found = std::ranges::find(lost_, folder, &CrashedSession::folder);
  if (found == lost_.end()) return;
  Session::discard(*found);
  lost_.erase(found);
}

std::string AppModel::why_not_kept() const {
  if (session_ != nullptr) return {};
  const std::string why = folders_.state.empty() ? "neither XDG_STATE_HOME nor HOME names a folder"
                                                 : "the folder " + folders_.state.string() + " cannot be written";
  return why +
         ", so nothing is saved by itself and a crash loses the terrain; set XDG_STATE_HOME to a folder of yours, or "
         "save checkpoints (Export)";
}

std::string AppModel::rescue() {
  const std::shared_ptr<const Snapshot> now = runner_->snapshot();
  if (!now->has_runs()) {
    return runner_->commands_given() > now->commands_done ? "the terrain was still being made; nothing was saved"
                                                          : "there was nothing to save";
  }
  if (session_ == nullptr) return "the runs are lost: " + why_not_kept();
  try {
    session_->save(*now);
  } catch (const std::exception& error) {
    return "the runs could not be saved: " + problem_of(error);
  }
  session_->keep();
  keep_settings();
  return "the runs are saved in " + session_->folder().string() + "; the next start offers them";
}

}  // namespace erg::session
