// The engine: slabs under the executor "cpu". A time step is cut into K sub-sweeps, each of which polls a random 1/K of
// the cells on a frozen surface, moves their slabs, and lets slopes slide. From K = 8 to 16 on it grows the same dunes
// as one slab at a time, on any number of threads with the same bits.
//
// A sub-sweep has four phases: *convey* (each thread follows its strips of lines down the wind; on skewed planes it
// then hands over the cells at its strips' edges), *carry* (slabs still in the air go on over the torus edge), *slide*
// (tiles, then the seams between their rows), *seams* (between blocks of columns). Barriers stand between them; where
// the lines of each thread stay in blocks of its own, before the seams alone. It is deterministic because decisions
// read only the frozen plane and keyed random numbers, lines never share a cell, and the edges of one class of slides
// are disjoint.
#pragma once

#include <utility>
#include <vector>

#include "compute/aligned_vector.h"
#include "compute/thread_pool.h"
#include "forcing/wind_frame.h"
#include "models/slab/slab_step.h"
#include "models/slab/sweep.h"
#include "process/allowance.h"

namespace erg::models {

class SlabEngine : public SlabSolver {
 public:
  /// On the threads of the executor's processor, in its sub-sweeps.
  explicit SlabEngine(compute::Executor& executor) : options_(executor.options()), pool_(executor.processor().pool()) {}

  void load(const Terrain& terrain, const forcing::WindFrame& frame) override;
  void sync_to_host(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const SlabLaw& law, const forcing::WindFrame& frame, double strength, StepKey key,
                  Grid<std::int32_t>* lift_counts) override;

 private:
  /// The grid in the frame's order, counted from the lowest bedrock, and the strips that work on it.
  template <typename Lane>
  struct Planes {
    compute::AlignedVector<Lane> before;
    compute::AlignedVector<Lane> after;
    compute::AlignedVector<Lane> bedrock;  ///< empty where level
    compute::AlignedVector<Lane> steps;    ///< critical step of each cell; empty where all are the same
    compute::AlignedVector<Lane> diagonal_steps;
    std::vector<Strip<Lane>> strips;
    compute::AlignedVector<Lane> rings;
    compute::AlignedVector<Overhang<Lane>> overhangs;  ///< of each strip and row; empty where planes are not skewed
    compute::AlignedVector<Lane> firsts;               ///< SlidePlan::firsts
    compute::AlignedVector<Lane> edges;                ///< SlidePlan::edges, of two sub-sweeps in turn
    compute::AlignedVector<Lane> seams;                ///< SlidePlan::seam, for each member
  };

  /// What the loaded cover, and the steps that stand under it, were made from.
  struct CoverSource {
    std::uint64_t stamp = 0;  ///< 0: none is loaded
    ReposeSteps bare;
    ReposeSteps covered;
    std::uint8_t covered_from = 0;

    bool operator==(const CoverSource&) const = default;
  };

  /// One time step under way.
  struct Progress {
    const SlabLaw* law = nullptr;
    StepKey key;
    StepAccount account;
    int highest = 0;       ///< bound on the highest cell
    bool crowded = false;  ///< the next sub-sweep needs 16-bit lanes
    SweepCounters counts;  ///< summed over sub-sweeps
  };

  template <typename Lane>
  auto& planes() {
    if constexpr (sizeof(Lane) == 1) {
      return narrow_planes_;
    } else {
      return wide_planes_;
    }
  }
  template <typename Lane>
  const Planes<Lane>& planes() const {
    return const_cast<SlabEngine*>(this)->planes<Lane>();
  }
  /// 8-bit lanes hold cells up to this bound, and a step more.
  bool narrow_fits(int highest) const { return highest + largest_step_ < 255; }

  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  bool lies_ready_for(const forcing::WindFrame& frame) const;
  bool turn_rows(const forcing::WindFrame& frame);
  template <typename Lane>
  void turn_rows_of(compute::AlignedVector<Lane>& plane, const PlaneLayout& wanted, bool mirrored);
  template <typename Visit>
  void visit_cells(const Visit& visit);
  template <typename Lane>
  void load_heights(const Terrain& terrain);
  void change_lanes(bool narrow);

  template <typename Lane>
  void load_cover(const SlabLaw& law);
  void prepare_walls(const SlabLaw& law);
  template <typename Lane>
  void prepare_hops(const SlabLaw& law, double strength, StepKey key);
  template <typename Lane>
  double mean_deviation(double mean);
  int ring_rows(int highest) const;
  template <typename Lane>
  void prepare_strips(int ring_rows);
  template <typename Lane>
  bool lines_stay_apart() const;
  void prepare_lift_counts(bool wanted);
  void add_lifted(int member);
  void add_lift_counts_to(Grid<std::int32_t>* lift_counts);

  bool goes_on(const Progress& progress) const;
  template <typename Lane>
  bool sweep_until_done(Progress& progress);
  template <typename Lane>
  Progress sweep_as_member(int member, Progress progress, int rows);
  static void take_account(Progress& progress, const SubSweep& done, const SweepCounters& counts, int bound);
  template <typename Lane>
  static SweepCounters summed(const std::vector<Strip<Lane>>& strips, int turn);
  void draw_round(const Progress& progress, int member);
  /// Which of the polled_rows_ is the round's: two in turn, for a member may draw those of the next round while another
  /// still polls by this one's.
  int rows_of_round(const Progress& progress) const { return progress.account.sweep / options_.sweeps % 2; }
  void barrier_unless(bool apart);
  template <typename Lane>
  void slide_blocks(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member, bool apart);
  template <typename Lane>
  void slide_seams(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member);
  int sweepers() const;
  template <typename Lane>
  void keep_firsts(const SweepKernels<Lane>& kernels, const SlidePlan<Lane>& plan, int member);
  static std::pair<int, int> share(int count, int member, int members);
  template <typename Lane>
  SweepPlan<Lane> sweep_plan(const Progress& progress) const;
  template <typename Lane>
  SlidePlan<Lane> slide_plan(const SweepPlan<Lane>& sweep, const SlabLaw& law, int member, int turn);

  const compute::ExecutorOptions options_;
  compute::ThreadPool& pool_;
  const int processors_ = process::allowed_threads();

  forcing::WindFrame frame_;
  PlaneLayout layout_;
  bool open_ = false;
  bool relief_ = false;
  bool narrow_ = true;
  std::int32_t base_ = 0;  ///< lowest bedrock
  std::int64_t bedrock_total_ = 0;
  std::int64_t mobile_total_ = 0;
  int highest_ = 0;  ///< bound on the highest cell over base_
  Planes<std::uint8_t> narrow_planes_;
  Planes<std::uint16_t> wide_planes_;
  compute::AlignedVector<std::uint8_t> cover_;
  compute::AlignedVector<std::uint8_t>
      lifted_;  ///< of one sub-sweep (SweepPlan::lifted); empty unless lifts are counted
  compute::AlignedVector<std::uint32_t> step_lifts_;  ///< of each cell in this step, with it
  CoverSource cover_source_;
  std::vector<std::uint8_t> wall_rows_;
  std::vector<std::uint32_t> hop_table_;
  PolledRows polled_rows_[2];
  int largest_step_ = 2;
};

}  // namespace erg::models
