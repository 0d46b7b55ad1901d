#include "session/run_group.h"

#include <algorithm>
#include <utility>

#include "core/errors.h"
#include "io/checkpoint/start_simulation.h"
#include "sim/memory.h"

namespace erg::session {

using io::Saved;
using sim::check_memory;
using sim::Config;
using sim::free_memory;
using sim::Simulation;

namespace {

/// Of a run's terrain, besides its own: the state that reset goes back to and up to three that are shown, in the
/// window's hands, published since then, and in the making.
constexpr int copies = 4;

/// What may be kept for undo, in bytes. At least one edit is kept, however large its terrain.
constexpr std::size_t most_undo_bytes = std::size_t{1} << 29;
constexpr std::size_t most_edits = 200;

std::size_t bytes_of(const RunGroup::Moment& moment) {
  std::size_t bytes = 0;
  for (const auto& state : moment) {
    const Terrain& terrain = state->terrain;
    bytes += terrain.extent().cells() * (2 * sizeof(std::int32_t) + terrain.fields().size() * sizeof(float));
  }
  return bytes;
}

template <typename Things, typename Wind>
void check_together(const Things& things, const Wind& wind_of) {
  if (things.empty()) throw InputError("", "there is nothing to create", "set up a run first");
  if (things.size() > most_runs) throw InputError("", "too many runs", "compare at most four");
  for (const auto& thing : things) {
    if (wind_of(thing) == wind_of(things.front())) continue;
    throw InputError("", "the runs have different winds", "runs that are compared need the same wind");
  }
}

RunGroup::Moment moment_of(const std::vector<std::unique_ptr<Simulation>>& runs) {
  RunGroup::Moment now;
  for (const auto& run : runs) now.push_back(std::make_shared<const sim::RunState>(run->state()));
  return now;
}

}  // namespace

bool RunGroup::finished() const {
  return !empty() && std::ranges::all_of(runs_, [](const auto& run) { return run->finished(); });
}

std::string RunGroup::why_finished() const { return empty() ? "" : runs_.front()->totals().why_finished; }

void RunGroup::take(std::vector<std::unique_ptr<Simulation>> runs) {
  Moment beginning = moment_of(runs);  // may not find the memory: then nothing has changed yet
  runs_ = std::move(runs);
  context_ = std::move(beginning);
  worked_ = {};
  // What blew before a checkpoint was written is not in it; its config says what was set then.
  blown_before_ = WindRecord::of(runs_.front()->config().wind, runs_.front()->step_count());
  blown_ = blown_before_;
}

void RunGroup::create(const std::vector<Config>& configs, std::vector<std::string>* notes) {
  check_together(configs, [](const Config& config) { return config.wind; });
  check_memory(configs, copies, free_memory());
  std::vector<std::unique_ptr<Simulation>> runs;
  for (const Config& config : configs)
    runs.push_back(std::make_unique<Simulation>(io::start_simulation(config, notes)));
  take(std::move(runs));
  forget_edits();
}

void RunGroup::resume(std::vector<Saved> saved) {
  check_together(saved, [](const Saved& one) { return one.config.wind; });
  std::vector<std::unique_ptr<Simulation>> runs;
  for (Saved& one : saved) {
    if (one.state.step != saved.front().state.step) {
      throw InputError("", "the runs stand at different steps", "resume runs that were saved together");
    }
  }
  std::vector<Config> configs;
  for (const Saved& one : saved) configs.push_back(one.config);
  check_memory(configs, copies - 1, free_memory());  // one is what was read
  for (Saved& one : saved) {
    runs.push_back(std::make_unique<Simulation>(std::move(one.config), std::move(one.state)));
  }
  take(std::move(runs));
  forget_edits();
}

void RunGroup::reset() {
  if (empty()) return;
  remember(0, 0);
  redo_.clear();
  go_to(context_, blown_before_);
  worked_ = {};
}

RunGroup::Moment RunGroup::moment() const { return moment_of(runs_); }

void RunGroup::go_to(const Moment& moment, const WindRecord& blown) {
  std::vector<std::unique_ptr<Simulation>> runs;
  for (std::size_t i = 0; i < moment.size(); ++i) {
    runs.push_back(std::make_unique<Simulation>(runs_[i]->config(), *moment[i]));
  }
  runs_ = std::move(runs);
  blown_ = blown;
}

std::int64_t RunGroup::step() {
  const auto begin = std::chrono::steady_clock::now();
  std::int64_t polls = 0;
  const std::int64_t before = step_count();
  for (const auto& run : runs_) polls += run->step().polls;
  if (step_count() > before) blown_.add(runs_.front()->last_wind());
  worked_ += std::chrono::steady_clock::now() - begin;
  return polls;
}

void RunGroup::change(const std::vector<Config>& configs) {
  if (configs.size() != size()) throw InputError("", "other runs than there are", "create them anew");
  check_together(configs, [](const Config& config) { return config.wind; });
  for (std::size_t i = 0; i < size(); ++i) {
    if (sim::needs_new_terrain(runs_[i]->config(), configs[i])) {
      throw InputError("", "this change needs a new terrain", "press CREATE");
    }
  }
  std::vector<Config> before;
  try {
    for (std::size_t i = 0; i < size(); ++i) {
      before.push_back(runs_[i]->config());
      if (before[i] != configs[i]) runs_[i]->change(configs[i]);
    }
  } catch (...) {
    // All of them or none: a run that refuses is as it was, those before it go back.
    for (std::size_t i = 0; i + 1 < before.size(); ++i) runs_[i]->change(before[i]);
    throw;
  }
}

void RunGroup::paint(std::size_t run, const BrushStamp& stamp, std::uint64_t stroke) {
  if (run >= size()) throw InputError("brush", "there is no such run", "create a terrain first");
  const bool new_stroke = undo_.empty() || undo_.back().stroke != stroke || undo_.back().run != run;
  if (new_stroke) remember(stroke, run);
  bool changed = false;
  try {
    changed = apply_stamp(runs_[run]->edit_terrain(), stamp);
  } catch (const InputError&) {
    if (new_stroke) undo_.pop_back();
    throw;
  }
  if (changed) {
    runs_[run]->book_edit();
    redo_.clear();
  } else if (new_stroke) {
    undo_.pop_back();
  }
}

std::uint64_t RunGroup::last_stroke(std::size_t run) const {
  for (auto edit = undo_.rbegin(); edit != undo_.rend() && edit->stroke != 0; ++edit) {
    if (edit->run == run) return edit->stroke;
  }
  return 0;
}

void RunGroup::remember(std::uint64_t stroke, std::size_t run) {
  undo_.push_back({stroke, run, worked_, blown_, moment()});
  const auto too_much = [this] {
    std::size_t bytes = 0;
    for (const Edit& edit : undo_) bytes += bytes_of(edit.state);
    return undo_.size() > most_edits || bytes > most_undo_bytes;
  };
  while (undo_.size() > 1 && too_much()) undo_.pop_front();
}

void RunGroup::forget_edits() {
  undo_.clear();
  redo_.clear();
}

bool RunGroup::undo() { return swap_with(undo_, redo_); }

bool RunGroup::redo() { return swap_with(redo_, undo_); }

bool RunGroup::swap_with(std::deque<Edit>& from, std::deque<Edit>& to) {
  if (from.empty()) return false;
  Edit present{from.back().stroke, from.back().run, worked_, blown_, moment()};
  go_to(from.back().state, from.back().blown);
  worked_ = from.back().worked;
  from.pop_back();
  to.push_back(std::move(present));
  return true;
}

}  // namespace erg::session
