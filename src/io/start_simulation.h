// From a config to a run, with the files that the config names.
#pragma once

#include <optional>

#include "io/provenance.h"
#include "sim/scene.h"
#include "sim/simulation.h"

namespace erg {

/// The decoded picture of an *image* scene; nothing for all other kinds. Throws InputError for a missing or damaged
/// file.
std::optional<HeightPicture> read_scene_picture(const Config& config);

/// The run that the config describes, at step 0, its picture read if the scene is one. Throws InputError.
Simulation start_simulation(const Config& config);

/// Where a file about this run, as it stands, says it comes from.
Provenance provenance_of(Simulation& simulation);

}  // namespace erg
