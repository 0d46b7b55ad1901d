// Nield & Baas 2008: slabs of sand among plants that grow with what the wind brings.
//
// Physics: Werner's slabs of a tenth of a cell; plants of effectiveness rho lower the chance that a slab lifts to 1 -
// rho and raise the chance that it stays to p + rho (1 - p), and hold steeper slopes (40 degrees from rho 0.3 on). Once
// a year rho follows the balance of sand (plants.h). Cimbura 2022 prints eq. 4.5 with a minus in the second, which
// would make plants repel sand; Baas 2002 has plus. Does not model: water, seasons of growth, roots, grazing.
#pragma once

namespace erg::models {

struct ModelType;

/// The catalogue entry.
ModelType nield_baas();

}  // namespace erg::models
