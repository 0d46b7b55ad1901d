// How long pictures take.
#pragma once

#include <string>
#include <vector>

namespace erg::app {

/// What a picture takes, s. On the processor it is the second that counts: it does not grow with what else runs.
struct PictureTime {
  double wall = 0;
  double processor = 0;  ///< of all threads of this program
};

/// Times for pictures of a grid.
struct RenderBenchRow {
  int grid = 0;         ///< cells a side
  std::string quality;  ///< "moving" or "still"
  std::string drawn;    ///< what is drawn of the grid: "512 x 512"
  PictureTime first;    ///< with programs compiled and everything uploaded and computed
  PictureTime turned;   ///< the camera turned, the terrain as before
  PictureTime tenth;    ///< a tenth of the cells changed, side by side
  PictureTime all;      ///< cells changed everywhere
  long long triangles = 0;
};

/// Draws dunes on grids of these sizes at 1280 x 720 pixels, without supersampling, into the graphics card's memory.
/// The best of several where pictures are quick. `renderer`: what draws, in words.
std::vector<RenderBenchRow> run_render_bench(const std::vector<int>& grids, const std::string& context,
                                             std::string& renderer);

}  // namespace erg::app
