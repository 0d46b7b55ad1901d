// Keeps the trajectories of grains for pictures.
#pragma once

#include <utility>
#include <vector>

#include "core/terrain.h"
#include "core/trajectory.h"
#include "forcing/wind_frame.h"
#include "models/grains/grain_cell.h"

namespace erg::models {

/// Watches flights (see `fly`) and notes every point, in metres of the terrain. Where a grain leaves a torus over one
/// side and enters over the other, its line ends and another begins.
class TrajectoryWatch {
 public:
  /// `lowest`: height (m) that the frozen ground counts from.
  TrajectoryWatch(const Terrain& terrain, const forcing::WindFrame& frame, double lowest);

  /// The next points are another grain's.
  void start();
  void at(const Grain& grain);
  void impact(int, int, int, float) {}

  std::vector<Trajectory> take_trajectories();

 private:
  forcing::WindFrame frame_;
  int nx_;
  float cell_size_;
  float lowest_;
  float last_u_ = 0;
  float last_v_ = 0;
  std::vector<Trajectory> trajectories_;
};

}  // namespace erg::models
