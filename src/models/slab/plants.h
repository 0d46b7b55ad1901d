// Plants on sand: how they stand at the start, and how they grow once a year with what the wind brought or took.
//
// Physics: the effectiveness rho of each species changes by a growth curve of the cell's yearly balance (m of sand a
// year, deposition positive) and stays within the species' range (Nield & Baas 2008; Baas 2002). The sum over the
// species, within 0 to 1, is what hinders erosion and helps deposition.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "compute/executor.h"
#include "core/binding.h"
#include "core/random.h"
#include "core/terrain.h"
#include "models/slab/slab_law.h"

namespace erg::models {

/// A species of plants: how it is at the start, and how it grows.
struct PlantSpecies {
  bool grows = false;
  float start = 0;  ///< rho where there are plants at first
  float low = 0;
  float high = 1;
  PiecewiseLinear growth;  ///< change of rho in a year by the cell's balance, m/yr
};
inline constexpr std::size_t species_count = 3;

/// The values of all parameters that concern plants: their declarations say what they mean.
struct PlantValues {
  std::int64_t steps_per_year = 80;
  std::string vegetation;
  std::string vegetation_image;
  bool scatter = false;
  std::array<PlantSpecies, species_count> species;
  bool spreading = false;
  double lateral_chance = 0;        ///< 1/yr
  double establishment_chance = 0;  ///< 1/yr
};

/// Their declarations.
const Binding<PlantValues>& plant_binding();
/// The layers that plants need.
std::vector<FieldInfo> plant_fields();
/// Keys of those that people may paint: each species by itself.
std::vector<std::string> painted_plants();

/// The plants of one run.
class Plants {
 public:
  /// `seed`: of the run.
  Plants(const PlantValues& values, std::uint64_t seed);

  /// Adds the fields to a terrain without them. `picture`: share of the start values in each cell for *image*; null:
  /// none anywhere.
  void begin(Terrain& terrain, const Grid<float>* picture);
  /// What acts on the slabs, 255 for rho = 1; made anew where the fields have changed.
  const Cover& cover(Terrain& terrain);
  /// The yearly change, from a terrain that is up to date. True where nothing can move any more, now or later: sand
  /// lies only under plants that hold all of it, and these change no more.
  bool grow(Terrain& terrain, StepKey key, compute::Executor& executor);

 private:
  /// The start of one cell as a share of the start values.
  float start_share(int x, int y, const Terrain& terrain, const Grid<float>* picture) const;
  /// Whether plants may come up in a bare cell this year; `stood`: where, with spreading, the species stood before.
  bool comes_up(const Grid<std::uint8_t>& stood, std::size_t cell, std::size_t species, StepKey key) const;
  static float total(const Terrain& terrain, std::size_t cell);

  PlantValues values_;
  StepKey planting_;
  Cover cover_;
  std::uint64_t fields_stamp_ = 0;  // of the fields that it was made from
};

}  // namespace erg::models
