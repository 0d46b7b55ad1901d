// The bed that grains fly over: whole counts of parcels in the wind's frame, the frozen ground made from them, and what
// the bed does by itself (slides, settling, bonding). All of it gives the same bits for any number of threads.
#pragma once

#include <cstdint>
#include <vector>

#include "core/parameters.h"
#include "core/random.h"
#include "core/terrain.h"
#include "models/grain_cell.h"
#include "transport/executor.h"
#include "wind/wind_frame.h"

namespace erg {

/// Keys of the layers that the grain model declares.
inline constexpr const char* plants_field = "vegetation";
inline constexpr const char* bonded_field = "bonded";

/// The share of the wind that these plants leave in each cell of the frame (1 without plants): next to nothing
/// where a plant stands, less and less taken away along the wake behind it.
std::vector<float> plant_shelter(const ParameterValues& values, const Terrain& terrain, const Grid<float>& plants,
                                 const WindFrame& frame);

class GrainBed {
 public:
  /// Takes the terrain's layers into the frame. `fall`: of the shadow line, quanta a cell.
  void load(const Terrain& terrain, const WindFrame& frame, double fall, const std::vector<float>& shelter);
  /// Writes mobile layer and bonded grains back.
  void store(Terrain& terrain) const;

  int width() const { return frame_.width; }
  int length() const { return frame_.length; }
  std::size_t cells() const { return mobile_.size(); }
  /// The height (m) that the frozen ground counts from.
  double lowest_height() const { return lowest_ * quantum_; }

  /// Makes the ground that the grains to come see.
  void freeze(Executor& executor);
  FrozenGround ground() const;

  /// Where a cell of the bed lies in the terrain.
  std::size_t terrain_cell(int u, int v) const { return frame_.cell(u, v); }

  /// A loose grain leaves the cell: at most one thread may do that for a cell.
  void take(int u, int v) { ++gone_[at(u, v)]; }
  /// A grain comes to rest in the cell; for any thread.
  void give(BedCell place) { add(come_, place.u, place.v, 1); }
  /// An impact asks for `grains` of the cell; `speed` in m/s. For any thread.
  void ask(int u, int v, int grains, float speed);

  /// Hands out what impacts asked for: takes loose grains and lets them hop. `make_hopper()` gives each thread its own
  /// hopper: hopper(u, v, k, mean impact speed) moves the k-th grain of a cell, hopper.finish() comes last. Where
  /// nothing is left loose, further impacts free bonded grains with chance `abrasion`.
  template <typename MakeHopper>
  void splash(Executor& executor, StepKey key, std::uint64_t sweep, double abrasion, const MakeHopper& make_hopper);
  /// Books all that was taken and given.
  void settle_accounts(Executor& executor);

  /// Lets slopes steeper than the standing steps slide, in at most `passes` passes.
  void slide(Executor& executor, StandingSteps steps, int passes, StepKey key, std::uint64_t sweep);
  /// Loose grains creep to lower neighbours, each with a chance of `chance` times the parcels between them.
  void creep(Executor& executor, double chance, StepKey key, std::uint64_t sweep);
  /// In a share of the cells all loose grains bond that have rested since the last `load`.
  void bond(Executor& executor, double share, StepKey key, std::uint64_t sweep);

 private:
  using Counts = std::vector<std::int32_t>;

  std::size_t at(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(frame_.width) + static_cast<std::size_t>(u);
  }
  /// A point of the frozen ground or of its rim.
  GroundPoint& point(int u, int v) { return points_[static_cast<std::size_t>(v + 1) * (frame_.width + 2) + u + 1]; }
  void add(Counts& counts, int u, int v, std::int32_t amount);
  void freeze_heights(std::int64_t first_row, std::int64_t last_row);
  void freeze_shadow(std::int64_t first_line, std::int64_t last_line, int start);
  void freeze_rim();
  int shadow_warm_up() const;
  int freed(std::size_t cell, int missing, double abrasion, StepKey key, std::uint64_t sweep);
  template <typename Rule>
  bool along_edges(Executor& executor, int direction, const Rule& rule);

  WindFrame frame_;
  bool torus_ = true;
  double quantum_ = 1;
  double fall_ = 1;  // quanta a cell
  std::int32_t lowest_ = 0;
  Counts bedrock_;
  Counts mobile_;
  Counts bonded_;
  Counts gone_;
  Counts come_;
  Counts stirred_;  // grains that came or went since the last load
  Counts asked_;
  Counts asked_speed_;  // in 1/64 m/s, summed over the grains asked for
  std::vector<float> shelter_;
  std::vector<GroundPoint> points_;
};

template <typename MakeHopper>
void GrainBed::splash(Executor& executor, StepKey key, std::uint64_t sweep, double abrasion,
                      const MakeHopper& make_hopper) {
  const FrozenGround ground = this->ground();
  executor.for_pieces(frame_.length, [&, ground](std::int64_t first, std::int64_t last) {
    auto hopper = make_hopper();
    for (int v = static_cast<int>(first); v < last; ++v) {
      for (int u = 0; u < frame_.width; ++u) {
        const std::size_t cell = at(u, v);
        const int asked = asked_[cell];
        if (asked == 0) continue;
        const int loose = ground.of_cell(u, v).loose - gone_[cell];
        const int going = asked < loose ? asked : loose;
        gone_[cell] += going;
        if (asked > loose) bonded_[cell] -= freed(cell, asked - loose, abrasion, key, sweep);
        const float speed = static_cast<float>(asked_speed_[cell]) / static_cast<float>(asked) / 64.0f;
        for (int k = 0; k < going; ++k) hopper(u, v, k, speed);
        asked_[cell] = asked_speed_[cell] = 0;
      }
    }
    hopper.finish();
  });
}

}  // namespace erg
