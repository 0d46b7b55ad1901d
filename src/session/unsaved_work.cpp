#include "session/unsaved_work.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/errors.h"

namespace erg::session {

using sim::Config;

namespace {

std::string name_of(const Config& config, std::size_t run, std::size_t runs) {
  const std::string title = config.title.empty() ? "this run" : quote(config.title);
  return runs > 1 ? "run " + std::to_string(run + 1) + ", " + title + "," : title;
}

}  // namespace

void UnsavedWork::start_from(const std::filesystem::path& file, Config config) {
  files_.clear();
  setup_saved(file, std::move(config));
}

void UnsavedWork::setup_saved(const std::filesystem::path& file, Config config) {
  files_.insert_or_assign(file, std::move(config));
}

void UnsavedWork::terrain_saved(const Snapshot& snapshot, std::size_t run) {
  if (creation_ != snapshot.creations) terrains_.clear();
  creation_ = snapshot.creations;
  std::erase_if(terrains_, [run](const TerrainWork& terrain) { return terrain.run == run; });
  terrains_.push_back({run, snapshot.runs[run].last_stroke, snapshot.seconds_worked});
}

void UnsavedWork::recovered(const Snapshot& snapshot) { recovered_creation_ = snapshot.creations; }

bool UnsavedWork::has(const Config& config) const {
  return std::ranges::any_of(files_, [&](const auto& file) { return file.second == config; });
}

const UnsavedWork::TerrainWork* UnsavedWork::kept_terrain(const Snapshot& snapshot, std::size_t run) const {
  if (creation_ != snapshot.creations) return nullptr;
  const auto found = std::ranges::find(terrains_, run, &TerrainWork::run);
  return found == terrains_.end() ? nullptr : &*found;
}

/// "" when it is none, or kept.
std::string UnsavedWork::why_terrain_is_work(const Snapshot& snapshot, std::size_t run) const {
  const TerrainWork* const kept = kept_terrain(snapshot, run);
  // After a reset the terrain has cost less than what was kept of the one before it.
  const bool kept_this = kept != nullptr && kept->seconds_worked <= snapshot.seconds_worked;
  const double worked = snapshot.seconds_worked - (kept_this ? kept->seconds_worked : 0);
  const std::uint64_t stroke = snapshot.runs[run].last_stroke;
  if (stroke != 0 && (kept == nullptr || stroke != kept->last_stroke)) return "was painted on";
  if (kept == nullptr && snapshot.creations == recovered_creation_) return "was recovered after a crash";
  if (worked < long_work) return {};
  return "has grown for " + std::to_string(std::lround(worked / 60)) + " minutes";
}

std::optional<UnsavedItem> UnsavedWork::missing_terrain(const Snapshot& snapshot) const {
  const std::size_t runs = snapshot.runs.size();
  for (std::size_t run = 0; run < runs; ++run) {
    const std::string why = why_terrain_is_work(snapshot, run);
    if (why.empty()) continue;
    return UnsavedItem{
        run, true,
        "The terrain of " + name_of(*snapshot.runs[run].config, run, runs) + " " + why + " and is in no file."};
  }
  return std::nullopt;
}

std::optional<UnsavedItem> UnsavedWork::missing(const Comparison& comparison, const Snapshot& snapshot,
                                                Leaves leaves) const {
  if (auto terrain = missing_terrain(snapshot); terrain || leaves == Leaves::terrain) return terrain;
  for (std::size_t run = 0; run < comparison.size(); ++run) {
    const Config config = comparison.config(run);
    if (has(config)) continue;
    return UnsavedItem{run, false,
                       "The setup of " + name_of(config, run, comparison.size()) + " was changed and is in no file."};
  }
  return std::nullopt;
}

}  // namespace erg::session
