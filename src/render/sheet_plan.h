// How a land is cut into sheets.
#pragma once

#include <vector>

#include "render/camera.h"
#include "render/effort.h"
#include "render/land_sheet.h"

namespace erg::render {

/// What decides how a land is cut.
struct SheetPlanRequest {
  const Terrain& terrain;
  const RenderEffort& effort;
  const picture::Camera& camera;
  LandBox land;
  int picture_height = 1;  ///< pixels
};

/// One sheet while the grid has no more than `effort.largest_side` cells a side, or when the effort is not tiled: then
/// in means of blocks. Otherwise several: near ones in single cells, far ones in blocks that the picture shows no
/// larger than a pixel, and larger blocks for all when they would hold more than a square of `effort.largest_side`.
std::vector<SheetPlace> plan_sheets(const SheetPlanRequest& request);

}  // namespace erg::render
