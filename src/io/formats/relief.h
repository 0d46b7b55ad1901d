// A terrain brought to the pixels of a picture: smooth heights, light and shade.
#pragma once

#include "core/terrain.h"

namespace erg::io {

/// Values at the pixels of a map, row 0 south.
struct Relief {
  Grid<float> surface;    ///< m
  Grid<float> sand;       ///< thickness of the mobile layer, quanta
  Grid<float> bedrock;    ///< m above the lowest bedrock
  double pixel_size = 1;  ///< m
  bool periodic = true;   ///< a torus

  Extent extent() const { return surface.extent(); }
};

/// How cells become pixels: either `zoom` pixels a cell, or block means on a smaller extent.
struct MapScale {
  Extent blocks;  ///< the grid itself, or fewer and larger cells
  int zoom = 1;   ///< pixels for the side of one
};

/// The scale at which the longer side has about `pixels` pixels.
MapScale map_scale(Extent grid, int pixels);

/// The value at the middle of each block: a field brought to fewer blocks.
Grid<float> nearest_blocks(const Grid<float>& values, Extent blocks);

/// Brings a layer of values (row-major, of extent scale.blocks) to the pixels: a Gaussian over `sigma` blocks, then
/// cubic B-splines. Both are smooth, so that whole slabs leave no terraces.
Grid<float> smooth_enlarge(const Grid<float>& values, double sigma, int zoom, bool periodic);

/// The relief of a terrain at a scale.
Relief make_relief(const Terrain& terrain, const MapScale& scale);

/// The one light that throws shadows.
struct Sun {
  double bearing = 300;  ///< degrees: where it stands
  double altitude = 30;  ///< degrees
};

/// Light that falls on each pixel, split in two: `sun` is the cosine of its angle of incidence relative to level
/// ground, times the part of the sun that is not hidden behind other ground; `sky` is the share of the sky that is
/// seen.
struct Light {
  Grid<float> sun;
  Grid<float> sky;
};

/// The light on every pixel of the relief.
Light light_up(const Relief& relief, const Sun& sun);

}  // namespace erg::io
