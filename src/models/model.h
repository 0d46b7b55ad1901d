// The one interface of all models. A model says what it is, as data, and what one time step does.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "compute/executor.h"
#include "core/binding.h"
#include "core/material.h"
#include "core/parameters.h"
#include "core/random.h"
#include "core/terrain.h"
#include "core/trajectory.h"
#include "forcing/wind_schedule.h"
#include "models/model_defaults.h"
#include "models/step_report.h"

namespace erg::models {

/// A scene on which the speed of a model is measured (`erg bench`).
struct BenchScene {
  std::string name = {};
  int steps = 0;                           ///< until its forms stand
  bool oblique = false;                    ///< under a wind that is turned from the grid
  std::vector<std::string> settings = {};  ///< what is changed of the model's own start, as `--set` takes it
};

/// What a model is, for people.
struct ModelInfo {
  std::string key = {};                ///< name in configs and on the command line
  std::string title = {};              ///< "Momiji et al. 2000"
  std::string citation = {};           ///< the publication
  std::string produces = {};           ///< what it makes
  std::string limitations = {};        ///< what it does not model
  std::string step = {};               ///< what one time step means
  std::string strength_label = {};     ///< what the wind's strength is: "hop length, cells"
  Material material = Material::sand;  ///< what it moves
  ModelDefaults start = {};            ///< the defaults of a config of this model
  /// Keys of the channels that it uses besides the wind (wind/channels.h). Others are not shown, and refused in a
  /// config.
  std::vector<std::string> channels = {};
  std::vector<std::string> painted = {};  ///< keys of the fields that people may paint
  bool moves_grains = false;              ///< of which trajectories can be kept (Model::keep_trajectories)
  /// The first is the plain one, which the others are set beside.
  std::vector<BenchScene> bench_scenes = {{.name = "dunes", .steps = 20},
                                          {.name = "oblique wind", .steps = 20, .oblique = true}};
};

/// What one time step stands for in the world.
struct StepScale {
  double seconds = 0;  ///< of the world; 0 where steps have no time of their own
  /// m2: volume (pores and all) that passes over flat ground, per metre across the wind; 0 where it is not known.
  double flux = 0;
};

/// What the beginning of a run may need besides the terrain.
struct InitContext {
  std::uint64_t seed = 0;
  forcing::Forcing weather = {};         ///< of the first step
  const Grid<float>* picture = nullptr;  ///< of the model's own path parameter: 0 black to 1 white, on the grid
};

/// A number that a model tells about itself, besides what every StepReport says.
struct Diagnostic {
  std::string key;    ///< name in `--stats`
  std::string label;  ///< name for people
  std::string unit;
  double value = 0;
};

/// A model at work on one terrain.
class Model {
 public:
  virtual ~Model() = default;

  /// Called before `begin`. What the argument points to lives until `begin` is over.
  virtual void prepare(const InitContext&) {}

  /// Height of one quantum in m.
  virtual double quantum() const = 0;
  /// Prepares the terrain before the first step (declared fields); also called when a run is resumed, then with fields
  /// already there.
  virtual void begin(Terrain& terrain) = 0;
  /// People have edited the terrain: brings up to date the fields that follow from what they did.
  virtual void edited(Terrain&) {}
  /// One time step.
  virtual StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) = 0;
  /// The fall of the wind shadow in quanta a cell, for pictures and numbers.
  virtual double shadow_fall(double cell_size) const = 0;

  /// Numbers of the model's own, of the last step unless their label says otherwise.
  virtual std::vector<Diagnostic> diagnostics() const { return {}; }
  /// From the next step on keeps the trajectories of about `count` of its grains; a model that moves no single grains
  /// has none.
  virtual void keep_trajectories(int count) { static_cast<void>(count); }
  /// The ways kept in the last step. On a torus a way that crosses an edge goes on as another, so that no line jumps.
  virtual std::vector<Trajectory> trajectories() const { return {}; }
};

/// A kind of model: what the catalogue lists.
struct ModelType {
  ModelInfo info;
  Declarations parameters;
  std::vector<FieldInfo> fields;
  /// Bytes a cell, at most, that a run keeps for this model besides terrain, fields and an executor's planes of slabs:
  /// a cover, a machine of its own. A run's need of memory is reckoned from it (sim/memory.h).
  std::uint64_t working_bytes;
  std::function<std::unique_ptr<Model>(const ParameterValues&)> make;
  /// What the values mean in slabs and cells, in words for people ("repose 33.7°: a step of 3 slabs stands").
  std::function<std::vector<std::string>(const ParameterValues&, double cell_size)> explain;
  /// What a step stands for under a wind of this mean strength; null: steps have no time of their own.
  std::function<StepScale(const ParameterValues&, double cell_size, double mean_strength)> step_scale = {};
};

/// A kind of model in terms of the struct that its parameters are bound to; becomes a ModelType.
template <typename Values>
struct ModelOf {
  ModelInfo info = {};
  Binding<Values> parameters;
  std::vector<FieldInfo> fields = {};
  std::uint64_t working_bytes = 0;
  std::function<std::unique_ptr<Model>(const Values&)> make = {};
  std::function<std::vector<std::string>(const Values&, double cell_size)> explain = {};
  std::function<StepScale(const Values&, double cell_size, double mean_strength)> step_scale = {};

  operator ModelType() const {
    ModelType type{
        info,
        parameters.declarations(),
        fields,
        working_bytes,
        [bound = parameters, called = make](const ParameterValues& values) { return called(bound.read(values)); },
        [bound = parameters, called = explain](const ParameterValues& values, double cell_size) {
          return called(bound.read(values), cell_size);
        }};
    if (step_scale) {
      type.step_scale = [bound = parameters, called = step_scale](const ParameterValues& values, double cell_size,
                                                                  double mean_strength) {
        return called(bound.read(values), cell_size, mean_strength);
      };
    }
    return type;
  }
};

/// Every model, in the order people should meet them (catalogue.cpp).
const std::deque<ModelType>& catalogue();

/// Adds a model to the catalogue of this program, at its end: for a program that links the library and brings a model
/// of its own. Configs, checkpoints and Simulation know it from then on. Call it before threads are started. Throws
/// InputError where the key is taken.
void add_model(ModelType model);

/// The model with this key; throws InputError with the nearest key.
const ModelType& find_model(const std::string& key);

}  // namespace erg::models
