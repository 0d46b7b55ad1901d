#include "session/session.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "core/errors.h"
#include "io/files/atomic_file.h"
#include "io/files/json_print.h"
#include "session/surroundings.h"
#include "sim/memory.h"

namespace erg::session {

using io::read_checkpoint;
using io::Saved;

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* name_start = "session-";
constexpr const char* session_name = "session.json";

/// Opens the lock file of a folder and tries to lock it; -1 when another program holds it or it cannot be opened.
int try_lock(const fs::path& folder, int more_flags) {
  const int file = ::open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC | more_flags, 0600);
  if (file < 0) return -1;
  if (::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

/// A checkpoint's name holds the number of its save: the checkpoints of the save before stay until session.json, which
/// names the new ones, is there.
std::string checkpoint_name(std::uint64_t save, std::size_t run) {
  return "run" + std::to_string(run + 1) + "-" + std::to_string(save) + ".checkpoint";
}

/// What differs whenever the runs do.
std::uint64_t version_of(const Snapshot& snapshot) {
  std::uint64_t newest = 0;
  for (const RunSnapshot& run : snapshot.runs) newest = std::max(newest, run.terrain_version);
  return newest;
}

void write_session(const fs::path& folder, const Snapshot& snapshot) {
  const std::uint64_t save = snapshot.number;
  Json json;
  json["saved_at"] = local_time("%Y-%m-%d %H:%M:%S");
  json["title"] = snapshot.runs.front().config->title;
  json["step"] = snapshot.step();
  json["runs"] = Json::array();
  for (std::size_t run = 0; run < snapshot.runs.size(); ++run) {
    const std::string name = checkpoint_name(save, run);
    io::write_checkpoint(folder / name, *snapshot.runs[run].config, snapshot.runs[run].state());
    json["runs"].push_back(name);
  }
  io::write_file_atomically(folder / session_name, io::pretty_json(json));
  // Only now are the older checkpoints of no use.
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    const bool named = std::ranges::find(json["runs"], Json(name)) != json["runs"].end();
    std::error_code ignored;
    if (name.starts_with("run") && !named) fs::remove(entry->path(), ignored);
  }
}

void remove_folders(const std::vector<fs::path>& folders) {
  std::error_code ignored;
  for (const fs::path& folder : folders) fs::remove_all(folder, ignored);
}

/// session.json of a folder; null when it is missing or damaged.
Json read_session(const fs::path& folder) {
  std::ifstream file(folder / session_name, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Json json = Json::parse(text, nullptr, false);
  const auto has = [&json](const char* key, Json::value_t type) {
    return json.is_object() && json.contains(key) && json[key].type() == type;
  };
  const bool whole = has("title", Json::value_t::string) && has("saved_at", Json::value_t::string) &&
                     json.contains("step") && json["step"].is_number_integer() && has("runs", Json::value_t::array) &&
                     !json["runs"].empty() &&
                     std::ranges::all_of(json["runs"], [](const Json& name) { return name.is_string(); });
  return whole ? json : Json();
}

/// The checkpoints in a folder, whatever session.json says.
std::vector<fs::path> checkpoints_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (entry->path().extension() == ".checkpoint") found.push_back(entry->path());
  }
  std::ranges::sort(found);
  return found;
}

/// The number of the save that a checkpoint of a session belongs to; 0 for any other name.
std::uint64_t save_of(const fs::path& checkpoint) {
  const std::string name = checkpoint.stem().string();
  const std::size_t dash = name.rfind('-');
  if (!name.starts_with("run") || dash == std::string::npos) return 0;
  std::uint64_t save = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data() + dash + 1, end, save);
  return read.ec == std::errc() && read.ptr == end ? save : 0;
}

/// The checkpoints that were saved last, all together. Of those with names of their own, the one written last.
std::vector<fs::path> newest_save(const std::vector<fs::path>& checkpoints) {
  if (checkpoints.empty()) return {};
  const auto written = [](const fs::path& file) {
    std::error_code failed;
    return fs::last_write_time(file, failed);
  };
  const auto newest = std::ranges::max_element(checkpoints, [&](const fs::path& a, const fs::path& b) {
    return std::pair(save_of(a), written(a)) < std::pair(save_of(b), written(b));
  });
  const std::uint64_t save = save_of(*newest);
  if (save == 0) return {*newest};
  std::vector<fs::path> together;
  std::ranges::copy_if(checkpoints, std::back_inserter(together),
                       [save](const fs::path& one) { return save_of(one) == save; });
  return together;
}

/// What is known of a session whose list is missing or damaged. Its checkpoints are read when it is recovered.
CrashedSession lost_without_list(const fs::path& folder, const std::vector<fs::path>& checkpoints) {
  CrashedSession lost{folder, "A session whose list is missing or damaged", "(unknown)", 0,
                      newest_save(checkpoints).size()};
  std::error_code failed;
  if (checkpoints.empty()) return lost;
  const auto written = fs::last_write_time(newest_save(checkpoints).front(), failed);
  const auto moment = std::chrono::file_clock::to_sys(written);
  if (!failed)
    lost.saved_at =
        local_time("%Y-%m-%d %H:%M:%S", std::chrono::system_clock::to_time_t(
                                            std::chrono::time_point_cast<std::chrono::system_clock::duration>(moment)));
  return lost;
}

}  // namespace

Session::Session(const fs::path& state_folder) : last_save_(std::chrono::steady_clock::now()) {
  const std::string process = std::to_string(::getpid());
  // A crash may have left a folder of the same number.
  for (int attempt = 0; attempt < 100 && lock_ < 0; ++attempt) {
    folder_ = state_folder / (name_start + process + (attempt > 0 ? "-" + std::to_string(attempt) : ""));
    std::error_code failed;
    fs::create_directories(state_folder, failed);
    if (!fs::create_directory(folder_, failed)) {
      if (failed) break;
      continue;
    }
    lock_ = try_lock(folder_, O_CREAT);
  }
  if (lock_ < 0) {
    throw InputError(state_folder.string(), "cannot keep the session here",
                     "check that this folder may be written; nothing is saved automatically");
  }
}

Session::~Session() {
  if (saving_.valid()) saving_.wait();
  if (!keep_) {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  ::close(lock_);
}

void Session::save_if_due(const std::shared_ptr<const Snapshot>& snapshot, double minutes) {
  using namespace std::chrono_literals;
  if (saving_.valid()) {
    if (saving_.wait_for(0s) != std::future_status::ready) return;
    problem_ = saving_.get();
    if (!problem_.empty()) saved_version_ = 0;  // tried again even if nothing changes: there may be room by then
  }
  const auto pause = std::chrono::duration<double>(minutes * 60);
  const auto now = std::chrono::steady_clock::now();
  if (minutes <= 0 || now - last_save_ < pause || !snapshot->has_runs() || version_of(*snapshot) == saved_version_) {
    return;
  }
  last_save_ = now;
  saved_version_ = version_of(*snapshot);
  const auto work = [folder = folder_, snapshot, old = replaced_]() -> std::string {
    try {
      write_session(folder, *snapshot);
      remove_folders(old);
    } catch (const std::exception& error) {
      return sim::problem_of(error);
    }
    return {};
  };
  try {
    saving_ = std::async(std::launch::async, work);
  } catch (const std::system_error& error) {  // no thread to be had
    problem_ = error.what();
    saved_version_ = 0;
  }
}

void Session::save(const Snapshot& snapshot) {
  if (!snapshot.has_runs()) return;
  if (saving_.valid()) problem_ = saving_.get();
  write_session(folder_, snapshot);
  remove_folders(replaced_);
  last_save_ = std::chrono::steady_clock::now();
  saved_version_ = version_of(snapshot);
}

void Session::replaces(const CrashedSession& session) { replaced_.push_back(session.folder); }

std::string Session::take_problem() { return std::exchange(problem_, {}); }

std::vector<CrashedSession> Session::lost(const fs::path& state_folder) {
  std::vector<CrashedSession> found;
  std::error_code failed;
  for (fs::directory_iterator entry(state_folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const fs::path folder = entry->path();
    if (!folder.filename().string().starts_with(name_start)) continue;
    const int lock = try_lock(folder, 0);
    if (lock < 0) continue;  // its program lives
    ::close(lock);
    std::error_code ignored;
    const Json json = read_session(folder);
    if (json.is_null()) {
      const std::vector<fs::path> left = checkpoints_in(folder);
      if (left.empty() && !fs::exists(folder / session_name, ignored)) {
        fs::remove_all(folder, ignored);  // a program that was gone before it saved anything: there is nothing to offer
      } else {
        found.push_back(lost_without_list(folder, left));
      }
      continue;
    }
    found.push_back({folder, json.value("title", ""), json.value("saved_at", ""), json.value("step", std::int64_t{0}),
                     json["runs"].size()});
  }
  std::ranges::sort(found, [](const CrashedSession& a, const CrashedSession& b) { return a.saved_at > b.saved_at; });
  return found;
}

std::vector<Saved> Session::recover(const CrashedSession& session) {
  const Json json = read_session(session.folder);
  std::vector<Saved> runs;
  if (json.is_null()) {
    for (const fs::path& checkpoint : newest_save(checkpoints_in(session.folder))) {
      runs.push_back(read_checkpoint(checkpoint));
    }
    if (!runs.empty()) return runs;
    throw InputError((session.folder / session_name).string(), "this list of what was saved is missing or damaged",
                     "no checkpoint lies beside it, so nothing can be brought back");
  }
  for (const Json& name : json["runs"]) {
    runs.push_back(read_checkpoint(session.folder / fs::path(name.get<std::string>()).filename()));
  }
  return runs;
}

void Session::discard(const CrashedSession& session) { remove_folders({session.folder}); }

}  // namespace erg::session
