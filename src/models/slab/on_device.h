// The terrain on a device, and the time steps of the slab machine there: the same sub-sweeps as the executor `cpu`,
// with one thread for each slab instead of one for each strip of lines.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "models/slab/plan.h"
#include "models/slab/slab_step.h"

namespace erg::models {

class SlabOnDevice : public SlabSolver {
 public:
  /// `sweeps` as in ExecutorOptions. This and all that follows throws DeviceError.
  SlabOnDevice(compute::Backend& device, int sweeps) : backend_(device), sweeps_(sweeps) {}

  void load(const Terrain& terrain, const forcing::WindFrame& frame) override;
  /// Brings back what has changed of the mobile layer.
  void sync_to_host(Terrain& terrain) override;
  StepReport step(Terrain& terrain, const SlabLaw& law, const forcing::WindFrame& frame, double strength, StepKey key,
                  Grid<std::int32_t>* lift_counts) override;
  /// A copy of the cover of the last step that stays as it is; null where there was none.
  std::shared_ptr<const Cover> kept_cover() const { return kept_cover_; }

 private:
  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  void allocate(const Terrain& terrain);
  void count_lifts(bool wanted);
  void take_lift_counts(Grid<std::int32_t>& counts);
  /// Lays the terrain out for a wind from another side.
  void turn(const forcing::WindFrame& frame);
  slab::Plan layout() const;
  slab::Plan step_plan(const SlabLaw& law, double strength, StepKey key);
  void lay_bare_bed(bool wanted);
  void drop_cover();
  void load_cover(const SlabLaw& law);
  void prepare_hops(slab::Plan& plan, const SlabLaw& law, double strength, StepKey key);
  double mean_deviation(const slab::Plan& plan, double mean);
  kernels::StepCounters read_counters();
  void sweep(const slab::Plan& plan);
  void slide(slab::Plan plan, const SlabLaw& law, const SubSweep& drawn);

  compute::Backend& backend_;
  int sweeps_;
  PolledRows polled_rows_;  // of the round under way
  forcing::WindFrame frame_;
  bool open_ = false;
  bool relief_ = false;
  std::int32_t base_ = 0;  // lowest bedrock
  std::int64_t bedrock_total_ = 0;
  std::int64_t mobile_total_ = 0;
  bool covered_ = false;           // bed words hold a cover
  std::uint64_t cover_stamp_ = 0;  // of the one that is loaded for this frame; 0: none
  std::shared_ptr<const Cover> kept_cover_;
  int current_ = 0;  // which of the two bounds belongs to before_

  compute::Buffer<std::uint32_t> before_;
  compute::Buffer<std::uint32_t> after_;
  compute::Buffer<std::uint32_t> bed_;  // empty where the bedrock is level and bare
  compute::Buffer<std::int32_t> staged_;
  compute::Buffer<std::int32_t> shown_;
  compute::Buffer<std::int32_t> lift_counts_;  // empty unless they are wanted
  compute::Buffer<std::uint32_t> bands_changed_;
  compute::Buffer<std::uint32_t> numbers_;
  compute::Buffer<slab::Aloft> aloft_;
  compute::Buffer<std::uint32_t> hop_table_;
  compute::Buffer<std::uint32_t> height_counts_;
};

}  // namespace erg::models
