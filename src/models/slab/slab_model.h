// What Werner, Momiji, Bishop and the models built on them share: the slab parameters, and the law made from them.
#pragma once

#include "models/model.h"
#include "models/slab/slab_step.h"

namespace erg::models {

/// What a time step and the wind's strength are in models of this family (ModelInfo).
inline constexpr const char* slab_step = "one step polls as many cells as the grid has";
inline constexpr const char* slab_strength = "hop length, cells";

/// Which parts of the slab law a model of this family uses.
struct SlabFamily {
  double repose_angle = 30;    ///< default, degrees
  bool lift_in_shadow = true;  ///< Werner lifts sand in the wind shadow, the others do not
  bool hop_grows_with_height = false;
  double deviation_weight = 0;       ///< of HopLaw
  double slab_height = 1.0 / 3;      ///< default, m
  const char* polling = "repeated";  ///< default
  bool timed_by_flux = true;         ///< `sand_flux` says how long a step is; false: the model says so by itself
};

/// How a step polls cells: each at random, or each exactly once.
enum class Polling { repeated, nonrepeated };

/// The values of the slab parameters, each under its key and in its unit: their declarations say what they mean. Those
/// that a family does not declare stay as they are here.
struct SlabValues {
  double slab_height = 0;   ///< m
  double repose_angle = 0;  ///< deg
  double shadow_angle = 0;  ///< deg
  double p_sand = 0;
  double p_bare = 0;
  double linear = 0;     ///< cells/slab
  double quadratic = 0;  ///< cells/slab^2
  Polling polling = Polling::repeated;
  bool forced_erosion = false;
  bool obstacles = false;
  int neighbours = 4;
  double sand_flux = 0;  ///< m²/year
};

/// The declarations that every model of the family has; with `linear` and `quadratic` where the hop grows with height,
/// and `sand_flux` where a step's time follows from it.
Binding<SlabValues> slab_binding(const SlabFamily& family);

/// What the values mean on a grid with cells of this size (m), in words: the repose in slabs, the fall of the shadow
/// line.
std::vector<std::string> explain_slabs(const SlabValues& values, double cell_size);

/// Volume that passes over flat ground covered with sand in a step, m2 (per metre across the wind, pores and all), in a
/// wind of this strength (cells a hop). Every cell lets one slab go on the mean, which comes to rest after 1 / p_sand
/// hops: strength / p_sand slabs pass a cell, each slab_height * cell_size for every metre across. Where hops grow with
/// height, strength is that at the reference height, which flat ground has. Cover, shadow and bare ground are left out.
/// 0 where slabs never come to rest.
double slab_flux(const SlabValues& values, double cell_size, double strength);

/// A step's time from `sand_flux`: the time in which so much sand passes in the world as in a step here.
StepScale slab_step_scale(const SlabValues& values, double cell_size, double strength);

/// A model that is nothing but its law. Those that do more derive from it.
class SlabModel : public Model {
 public:
  SlabModel(const SlabFamily& family, const SlabValues& values);

  double quantum() const override;
  void begin(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const forcing::Forcing& wind, StepKey key, compute::Executor& executor) override;
  double shadow_fall(double cell_size) const override;

  /// The law on this terrain's grid.
  SlabLaw law(const Terrain& terrain) const;

 private:
  SlabFamily family_;
  SlabValues values_;
};

/// The catalogue entry of a model of this family that is nothing but its law; says what step and strength are.
ModelType slab_model_type(ModelInfo info, SlabFamily family);

}  // namespace erg::models
