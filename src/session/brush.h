// Painting: sand and rock put on the ground or taken from it, and declared layers such as plants.
#pragma once

#include <cstdint>
#include <string>

#include "core/terrain.h"

namespace erg::session {

/// What a brush puts down.
enum class BrushMaterial {
  sand,  ///< the mobile layer: sand or snow
  rock,  ///< bedrock, which nothing moves; the mobile layer on it is lifted along
  field  ///< a declared layer of the model, such as plants
};

/// One touch of a brush.
struct BrushStamp {
  BrushMaterial material = BrushMaterial::sand;
  double x = 0;       ///< cells east of the grid's western edge (a cell's centre lies at its index + 0.5)
  double y = 0;       ///< cells north of the southern edge
  double radius = 8;  ///< cells, smallest_brush to largest_brush
  /// Sand, rock: quanta at the middle, falling smoothly to none at the radius; negative takes away.
  std::int32_t amount = 1;
  std::string field = {};  ///< field: its key
  double strength = 0;     ///< field: what is added at the middle, in the field's unit; kept within its range
};

inline constexpr double smallest_brush = 0.5;
inline constexpr double largest_brush = 512;

/// Puts one stamp on the terrain: on a torus also across its edges, on an open grid cut off at them. Sand is taken only
/// where some lies. Says whether a cell changed. Throws InputError, and leaves the terrain as it was, when the ground
/// would become higher than executors count, or for a field that the model does not have. The ledger is the caller's
/// (Simulation::book_edit).
bool apply_stamp(Terrain& terrain, const BrushStamp& stamp);

}  // namespace erg::session
