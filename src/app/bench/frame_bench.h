// What it takes to bring a step to the screen, besides drawing.
#pragma once

#include <string>
#include <vector>

namespace erg::app {

/// Seconds of the processor, all threads together, that a frame of a grid takes: the least of some frames, a step after
/// each other.
struct FrameBenchRow {
  int grid = 0;          ///< cells a side
  double settling = 0;   ///< the terrain comes back from the executor
  double copying = 0;    ///< it is copied, for the worker to go on
  double ranges = 0;     ///< its lowest and highest point
  double reading = 0;    ///< heights and thicknesses in metres are made of counts
  double comparing = 0;  ///< tiles that changed are found
  double uploading = 0;  ///< and brought to what draws

  double whole() const { return settling + copying + ranges + reading + comparing + uploading; }
};

/// Steps transverse dunes on grids of these sizes, every cell drawn. `renderer`: what draws, in words.
std::vector<FrameBenchRow> run_frame_bench(const std::vector<int>& grids, const std::string& context,
                                           std::string& renderer);

}  // namespace erg::app
