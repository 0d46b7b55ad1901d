// How long pictures take.
#pragma once

#include <string>
#include <vector>

namespace erg {

/// Seconds for one picture of a grid.
struct RenderBenchRow {
  int grid = 0;         ///< cells a side
  std::string quality;  ///< "moving" or "still"
  std::string drawn;    ///< what is drawn of the grid: "512 x 512"
  double first = 0;     ///< with everything uploaded and computed
  double turned = 0;    ///< the camera turned, the land as before
  double changed = 0;   ///< a tenth of the cells changed
  long long triangles = 0;
};

/// Draws dunes on grids of these sizes at 1280 x 720 pixels, without supersampling. `renderer`: what draws, in words.
std::vector<RenderBenchRow> run_render_bench(const std::vector<int>& grids, const std::string& context,
                                             std::string& renderer);

}  // namespace erg
