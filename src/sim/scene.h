// Scenes: what lies on the grid before the first step.
#pragma once

#include "core/terrain.h"
#include "sim/config.h"

namespace erg {

/// A surface read from a picture, 0 (black) to 1 (white); row 0 south.
using HeightPicture = Grid<float>;

/// The picture brought to the extent of a grid.
Grid<float> resample(const HeightPicture& picture, Extent extent);

/// Builds the terrain that `config` asks for, with its ledger open: *flat*, *random*, *ripples*, *transverse*, *rocks*,
/// *uneven*, *hump*, *dune*, *valley*, *cone* or *image*. `quantum` in m. `picture` is the decoded image of the *image*
/// scene, already read (this layer reads no files), resampled here to the grid; null for all other kinds.
Terrain build_scene(const Config& config, double quantum, const HeightPicture* picture = nullptr);

}  // namespace erg
