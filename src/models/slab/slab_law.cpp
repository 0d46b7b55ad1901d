#include "models/slab/slab_law.h"

#include <numbers>

#include "core/units.h"

namespace erg::models {

double HopLaw::cells(double strength, double above_reference) const {
  return hop_cells(strength, linear, quadratic, above_reference);
}

ReposeSteps ReposeSteps::of_angle(double angle, double cell_size, double slab_height) {
  return {erg::critical_step(angle, cell_size, slab_height),
          erg::critical_step(angle, cell_size * std::numbers::sqrt2, slab_height)};
}

}  // namespace erg::models
