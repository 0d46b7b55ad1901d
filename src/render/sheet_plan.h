// How a terrain is cut into sheets.
#pragma once

#include <vector>

#include "render/camera.h"
#include "render/quality.h"
#include "render/terrain_sheet.h"

namespace erg::render {

/// What decides how a terrain is cut.
struct SheetPlanRequest {
  const Terrain& terrain;
  const RenderQuality& quality;
  const picture::Camera& camera;
  TerrainBox box;
  int picture_height = 1;  ///< pixels
};

/// One sheet while the grid has no more than `quality.largest_side` cells a side, or when the quality is not tiled:
/// then in means of blocks. Otherwise several: near ones in single cells, far ones in blocks that the picture shows no
/// larger than a pixel, and larger blocks for all when they would hold more than a square of `quality.largest_side`.
std::vector<SheetPlace> plan_sheets(const SheetPlanRequest& request);

}  // namespace erg::render
