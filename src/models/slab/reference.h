// The reference: one slab at a time, each seeing the surface that the last one left, as the models were
// published (Cimbura 2022, algorithms 2-7). Slow and plain; the parallel engine is tested against its statistics.
#pragma once

#include <vector>

#include "forcing/wind_frame.h"
#include "models/slab/slab_step.h"

namespace erg::models {

/// Slabs under the executor "serial".
class SlabReference : public SlabSolver {
 public:
  void load(const Terrain& terrain, const forcing::WindFrame& frame) override;
  void sync_to_host(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const SlabLaw& law, const forcing::WindFrame& frame, double strength, StepKey key,
                  Grid<std::int32_t>* lift_counts) override;

 private:
  /// A place in the frame. v may run over the edge while a slab flies.
  struct Place {
    int u = 0;
    int v = 0;
  };
  /// One slab's random numbers, in the order it needs them.
  struct Draws {
    std::uint64_t base;
    std::uint64_t count = 0;
    std::uint64_t next();
    double unit() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  };

  void prepare(const SlabLaw& law);
  void count_heights();
  void measure_relief();
  std::size_t index(int u, int v) const {
    return static_cast<std::size_t>(u) * static_cast<std::size_t>(frame_.length) + static_cast<std::size_t>(v);
  }
  Place place_of(std::size_t cell) const {
    return {static_cast<int>(cell / static_cast<std::size_t>(frame_.length)),
            static_cast<int>(cell % static_cast<std::size_t>(frame_.length))};
  }
  std::size_t polled_cell(std::int64_t poll);
  void shuffle(std::uint64_t round);
  bool anything_can_move(Draws draws);

  bool lift(std::size_t cell, Draws& draws);
  std::size_t steepest_neighbour(Place place, bool uphill) const;
  void fly(Place place, int hop, Draws& draws);
  void enter(Draws& draws, Place entry);
  void let_inflow_enter();
  void deposit(Place place);
  bool in_shadow(Place place, Draws& draws) const;
  bool inside(int& u, int& v) const;
  /// Bedrock under a cell, without a look into memory where it is level.
  std::int32_t ground(std::size_t cell) const { return has_relief_ ? bedrock_[cell] : 0; }
  double stay_chance(std::size_t cell) const;
  int hop_rows(std::int32_t height, Draws& draws) const;
  bool covered(std::size_t cell) const { return !cover_.empty() && cover_[cell] >= law_.covered_from; }
  void change(std::size_t cell, int slabs);

  forcing::WindFrame frame_;
  bool open_ = false;
  bool has_relief_ = false;
  // Heights over lowest_, along the wind fastest: a look upwind reads neighbours in memory. 16 bits, since the random
  // walk through memory is what costs time.
  std::vector<std::uint16_t> surface_;
  std::vector<std::uint16_t> bedrock_;
  std::vector<std::uint8_t> cover_;
  std::vector<std::uint32_t> order_;

  // How many cells have each height over lowest_: the highest cell and Bishop's sum come from it at once.
  std::vector<std::int64_t> height_count_;
  std::int32_t lowest_ = 0;
  std::int32_t highest_ = 0;
  double mean_ = 0;
  double deviation_ = 0;  ///< sum of |h - mean|

  SlabLaw law_;
  double strength_ = 0;
  StepKey key_;
  std::int64_t row_fall_ = 0;  ///< ShadowFalls, in 1/256 slabs
  std::int64_t next_fall_ = 0;
  std::int64_t second_fall_ = 0;
  Grid<std::int32_t>* lift_counts_ = nullptr;
  StepReport report_;
};

}  // namespace erg::models
