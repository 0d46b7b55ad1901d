// How much work goes into a picture.
#pragma once

namespace erg::render {

/// What limits the work, by what draws and for whom.
struct RenderQuality {
  int largest_side = 4096;  ///< cells a side that are drawn as one; what larger grids become is told by `tiled`
  int largest_map = 4096;  ///< texels a side of the smooth surface, which has two for the side of a cell where they fit
  double step_pixels = 2;  ///< length of the terrain's triangles in the picture
  int finest = 256;        ///< most steps for 64 cells
  bool grains = true;      ///< grains, ripples and stones
  /// Larger grids are drawn in sheets, each as fine as the picture shows it; otherwise as means of blocks of cells.
  bool tiled = true;
  int smoothings = 2;          ///< 2: bumps of some cells go too; 1: single slabs only
  double light_share = 1;      ///< texels of the light for the side of one of the surface
  double light_stride = 0.05;  ///< growth of the steps towards the skyline, as a share of the way
  int sky_directions = 16;     ///< in which the open sky is looked for
  int sky_steps = 9;           ///< in each of them, up to a hundred texels
  int most_tufts = 1 << 20;    ///< of plants
  int coarseness = 1;          ///< pixels a side that are drawn as one

  /// A still picture, with all there is.
  static RenderQuality still() { return {}; }
  /// A picture at once while a person moves or the terrain changes: on a graphics card, or on the processor.
  static RenderQuality moving(bool software) {
    RenderQuality quality;
    quality.step_pixels = 3;
    quality.finest = 128;
    if (!software) return quality;
    quality.largest_side = 256;
    quality.largest_map = 256;
    quality.step_pixels = 10;
    quality.finest = 16;
    quality.grains = false;
    quality.tiled = false;
    quality.smoothings = 1;
    quality.light_share = 0.5;
    quality.light_stride = 0.25;
    quality.sky_directions = 6;
    quality.sky_steps = 5;
    quality.most_tufts = 3000;
    quality.coarseness = 2;
    return quality;
  }
};

}  // namespace erg::render
