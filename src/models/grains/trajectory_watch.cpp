#include "models/grains/trajectory_watch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace erg::models {

TrajectoryWatch::TrajectoryWatch(const Terrain& terrain, const forcing::WindFrame& frame, double lowest)
    : frame_(frame),
      nx_(terrain.nx()),
      cell_size_(static_cast<float>(terrain.cell_size())),
      lowest_(static_cast<float>(lowest)) {}

void TrajectoryWatch::start() {
  if (trajectories_.empty() || !trajectories_.back().empty()) trajectories_.emplace_back();
}

void TrajectoryWatch::at(const Grain& grain) {
  // A grain moves far less than half the grid in a time step, unless it was folded over an edge.
  const bool folded = std::abs(grain.u - last_u_) > 0.5f * static_cast<float>(frame_.width) ||
                      std::abs(grain.v - last_v_) > 0.5f * static_cast<float>(frame_.length);
  if (!trajectories_.back().empty() && folded) trajectories_.emplace_back();
  last_u_ = grain.u;
  last_v_ = grain.v;
  // The frame's axes lie along the terrain's, perhaps swapped or turned round.
  const auto axis = [](std::ptrdiff_t step, float place, float& x, float& y) {
    const bool along_x = std::abs(step) == 1;
    (along_x ? x : y) += (step > 0 ? place - 0.5f : 0.5f - place);
  };
  const auto row = frame_.origin / nx_;
  float x = static_cast<float>(frame_.origin - row * nx_) + 0.5f;
  float y = static_cast<float>(row) + 0.5f;
  axis(frame_.step_u, grain.u, x, y);
  axis(frame_.step_v, grain.v, x, y);
  trajectories_.back().push_back({x * cell_size_, y * cell_size_, lowest_ + grain.z});
}

std::vector<Trajectory> TrajectoryWatch::take_trajectories() {
  std::erase_if(trajectories_, [](const Trajectory& path) { return path.size() < 2; });
  return std::move(trajectories_);
}

}  // namespace erg::models
