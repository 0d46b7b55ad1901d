// A run: terrain, model, wind, clock and executor in one place. Everything else only looks at it.
#pragma once

#include <cstdint>
#include <memory>

#include "compute/executor.h"
#include "core/share_work.h"
#include "core/terrain.h"
#include "models/model.h"
#include "sim/config.h"
#include "sim/flux_watch.h"
#include "sim/scene.h"

namespace erg::sim {

/// The part of a run that a checkpoint holds besides its config.
struct RunState {
  Terrain terrain;
  std::int64_t step = 0;
  models::StepReport totals;
};

/// Whether a run cannot go on from `running` to `wanted` without a new terrain: another model, or another value of what
/// is read only at the start (grid, scene, seed, some of a model's parameters).
bool needs_new_terrain(const Config& running, const Config& wanted);

class Simulation {
 public:
  /// Builds the scene. `picture` as in build_scene; `model_picture`: that of the model's own path parameter. Throws
  /// InputError where the config is none of its model (check_config) or its scene cannot be built.
  explicit Simulation(Config config, const HeightPicture* picture = nullptr,
                      const HeightPicture* model_picture = nullptr);
  /// Goes on from a saved state. Throws InputError where a run of this config cannot (check_state).
  Simulation(Config config, RunState state);

  const Config& config() const { return config_; }
  const models::ModelType& model_type() const { return *type_; }
  const models::Model& model() const { return *model_; }
  /// Keeps the trajectories of about so many grains of every step to come (Model::keep_trajectories), under other
  /// configs too.
  void keep_trajectories(int count);
  /// From the next step on counts how many quanta are lifted from each cell, for `flux`; false: no longer. Steps take
  /// somewhat longer; what they do does not change.
  void watch_flux(bool wanted);
  /// What it counts; null where that is not wanted.
  const FluxWatch* flux() const { return flux_.get(); }
  /// Steps done.
  std::int64_t step_count() const { return state_.step; }
  /// The wind of the step to come.
  forcing::Forcing wind() const { return weather(state_.step); }
  /// The wind of the last step done (of the first, before it).
  forcing::Forcing last_wind() const;
  compute::Executor& executor() { return *executor_; }
  /// Shares work out to its threads, between steps; as long as the executor is this one.
  ShareWork share_work() {
    return [this](std::int64_t items, const PartOfWork& part) { executor_->parallel_for(items, part); };
  }
  const models::StepReport& totals() const { return state_.totals; }
  bool finished() const { return state_.totals.finished; }

  /// One time step; what it did. Does nothing when finished. Throws InputError after an edit that was not booked.
  models::StepReport step();
  /// The terrain, up to date.
  const Terrain& terrain();
  /// The terrain for editing (painting, events); book_edit, afterwards, books in the ledger what the edit added or
  /// took, and lets the model know (Model::edited). It throws InputError for an edit that no run can go on from: cells
  /// that hold less than nothing, heights, values or extents out of range, fields that are gone. Then mend it and book
  /// again.
  Terrain& edit_terrain();
  void book_edit();
  /// Goes on under another config from the next step on, as a run resumed from here would. A run that had come to its
  /// end may move again. Throws InputError, and leaves all as it was, where needs_new_terrain.
  void change(Config config);
  /// What a checkpoint needs.
  const RunState& state();

 private:
  void start();
  void wake();
  forcing::Forcing weather(std::int64_t step) const;
  void begin_model(const HeightPicture* picture);
  void check_edit() const;

  Config config_;
  RunValues run_;  // of the config
  const models::ModelType* type_ = nullptr;
  std::unique_ptr<models::Model> model_;
  std::unique_ptr<compute::Executor> executor_;
  RunState state_;
  std::unique_ptr<FluxWatch> flux_;  // the executor counts there
  int trajectories_wanted_ = 0;
  bool edited_ = false;  // since the last step or book_edit
};

}  // namespace erg::sim
