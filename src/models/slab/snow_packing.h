// Snow that packs until the wind can move it no more (after Cimbura 2022, sections 4.8 and 5.12).
//
// Physics: Werner's slabs, of snow. Each cell has a resistance r that acts as plants do (chance to lift 1 - r, chance
// to stay p + r (1 - p)) and grows every day, the faster the warmer; from r = 1 on a cell is frozen. Print multiplies
// the growth by a temperature that is 0 at -20 deg C, so that its own example could not freeze; here r starts at the
// fresh snow's density over the class's highest, and a day adds
//
//     rate * exp(0.04 T) * exp(-k2 day)
//
// 0.04 per degree is that of snow metamorphism (Anderson 1976), k2 that of the snow class (Sturm et al. 2010), and the
// rate is fitted to the printed 98 days at -20 deg C. Does not model: melting, snowfall, layers, sunshine.
#pragma once

namespace erg::models {

struct ModelType;

/// The catalogue entry.
ModelType snow_packing();

}  // namespace erg::models
