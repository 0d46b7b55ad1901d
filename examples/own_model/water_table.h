// Werner's dunes over ground water: the wind takes sand down to the wet ground and no further.
//
// Physics: sand at the water table sticks together, so the table is a floor to the wind's work (Stokes 1968), and what
// blows onto wet ground stays. Above the table lies a capillary fringe that is the drier the higher. Does not model: a
// table that rises under dunes, rain, evaporation, salt.
#pragma once

#include "models/model.h"

namespace erg {

/// The catalogue entry.
models::ModelType water_table();

}  // namespace erg
