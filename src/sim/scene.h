// Scenes: what lies on the grid before the first step.
#pragma once

#include "core/terrain.h"
#include "sim/config.h"
#include "sim/height_picture.h"

namespace erg::sim {

/// Heights of the picture's black and white points: the scene's, or what the picture says of itself where the scene
/// sets neither `image_low` nor `image_high`.
HeightRange image_heights(const ParameterValues& scene, const HeightPicture& picture);

/// Builds the terrain that `config` asks for, with its ledger open: *flat*, *random*, *ripples*, *transverse*, *rocks*,
/// *uneven*, *hump*, *dune*, *valley*, *cone* or *image*. `quantum` in m. `picture` is the decoded image of the *image*
/// scene, already read (this layer reads no files), resampled here to the grid; null for all other kinds.
Terrain build_scene(const Config& config, double quantum, const HeightPicture* picture = nullptr);

}  // namespace erg::sim
