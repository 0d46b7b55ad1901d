#include "transport/slab_law.h"

#include <algorithm>
#include <numbers>

#include "core/units.h"

namespace erg {

double HopLaw::cells(double strength, double above_reference) const {
  double length = strength + linear * above_reference;
  if (above_reference > 0) length += quadratic * above_reference * above_reference;
  return std::max(shortest_hop, length);
}

StandingSteps StandingSteps::of_angle(double angle, double cell_size, double slab_height) {
  return {erg::standing_step(angle, cell_size, slab_height),
          erg::standing_step(angle, cell_size * std::numbers::sqrt2, slab_height)};
}

}  // namespace erg
