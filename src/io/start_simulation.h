// From a config to a run, with the files that the config names.
#pragma once

#include <optional>

#include "io/provenance.h"
#include "sim/scene.h"
#include "sim/simulation.h"

namespace erg {

/// The decoded picture that a group of values wants (of an *image* scene, of a model); nothing where it wants none.
/// Throws InputError for a missing or damaged file.
std::optional<HeightPicture> read_picture_of(const ParameterValues& values);

/// The run that the config describes, at step 0, with the pictures that it wants. Throws InputError.
Simulation start_simulation(const Config& config);

/// Where a file about this run, as it stands, says it comes from.
Provenance provenance_of(Simulation& simulation);

}  // namespace erg
