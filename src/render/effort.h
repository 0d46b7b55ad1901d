// How much work goes into a picture.
#pragma once

namespace erg::render {

/// What limits the work, by what draws and for whom.
struct RenderEffort {
  int largest_side = 4096;  ///< cells a side that are drawn as one; what larger grids become is told by `tiled`
  int largest_map = 4096;  ///< texels a side of the smooth surface, which has two for the side of a cell where they fit
  double step_pixels = 2;  ///< length of the land's triangles in the picture
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
  static RenderEffort still() { return {}; }
  /// A picture at once while a person moves or the land changes: on a graphics card, or on the processor.
  static RenderEffort moving(bool software) {
    RenderEffort effort;
    effort.step_pixels = 3;
    effort.finest = 128;
    if (!software) return effort;
    effort.largest_side = 256;
    effort.largest_map = 256;
    effort.step_pixels = 10;
    effort.finest = 16;
    effort.grains = false;
    effort.tiled = false;
    effort.smoothings = 1;
    effort.light_share = 0.5;
    effort.light_stride = 0.25;
    effort.sky_directions = 6;
    effort.sky_steps = 5;
    effort.most_tufts = 3000;
    effort.coarseness = 2;
    return effort;
  }
};

}  // namespace erg::render
