// A time step of drifting, bonding snow as data: all that an executor knows of the model, and where a terrain keeps its
// snow.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/terrain.h"
#include "models/snow/snow_cell.h"

namespace erg::models {

/// The fields of a snow terrain, in this order.
enum class SnowLayer : std::size_t {
  loose,    ///< slabs on top that have not bonded
  bonded,   ///< slabs that have
  age,      ///< mean age of the bonded part, h
  landed,   ///< when a slab last came down, h since the beginning
  strength  ///< of the uppermost bonded snow; written by steps that show it
};

inline Grid<float>& snow_layer(std::vector<Field>& fields, SnowLayer layer) {
  return fields[static_cast<std::size_t>(layer)].values;
}
inline const Grid<float>& snow_layer(const std::vector<Field>& fields, SnowLayer layer) {
  return fields[static_cast<std::size_t>(layer)].values;
}

/// The loose slabs of a cell by its layer of bonded ones. Snow that somebody painted is loose; what somebody took away
/// was the loose part first.
inline std::int32_t loose_slabs(std::int32_t mobile, float bonded) {
  return std::max(0, mobile - static_cast<std::int32_t>(bonded));
}

/// Cells from the middle to the edge of the boxes over which heights are averaged.
struct SnowRadii {
  int smooth = 3;   ///< for the smoothed surface
  int around = 10;  ///< for its surroundings
};

struct SnowStep {
  SnowLaw law;
  SnowRadii radii;
  double shadow_fall = 1;       ///< slabs a cell: the shadow line behind a crest
  bool shows_strength = false;  ///< writes SnowLayer::strength
};

}  // namespace erg::models
