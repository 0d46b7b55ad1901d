// The terrain on a device, and the time steps of the slab machine there: the same sub-sweeps as the executor `cpu`,
// with one thread for each slab instead of one for each strip of lines.
#pragma once

#include <cstdint>
#include <vector>

#include "cuda/device.h"
#include "cuda/device_plan.h"
#include "cuda/device_tally.h"
#include "forcing/wind_frame.h"
#include "transport/executor.h"

namespace erg {

class DeviceSlabs {
 public:
  /// `sweeps` as in ExecutorOptions.
  DeviceSlabs(Device& device, int sweeps) : device_(device), sweeps_(sweeps) {}

  /// Brings the terrain to the device. This and all that follows throws DeviceError; load and step throw InputError for
  /// a terrain that is too high.
  void load(const Terrain& terrain, const WindFrame& frame);
  /// One time step of what is loaded.
  StepReport step(const SlabLaw& law, const WindFrame& frame, double strength, StepKey key);
  /// Counts, in the steps to come, the slabs lifted from each cell (Executor::count_lifts), or stops.
  void count_lifts(bool wanted);
  /// Adds what was counted since this was last called to `counts`.
  void take_lift_counts(Grid<std::int32_t>& counts);
  /// Brings back what has changed of the mobile layer since it was last brought back, or loaded. The terrain must be
  /// the one that was loaded.
  void settle(Terrain& terrain);

 private:
  std::int64_t cells() const { return static_cast<std::int64_t>(frame_.width) * frame_.length; }
  void allocate(const Terrain& terrain);
  /// Lays the terrain out for a wind from another side.
  void turn(const WindFrame& frame);
  DevicePlan layout() const;
  DevicePlan step_plan(const SlabLaw& law, double strength, StepKey key);
  void load_cover(const SlabLaw& law);
  void prepare_hops(DevicePlan& plan, const SlabLaw& law, double strength, StepKey key);
  double mean_deviation(const DevicePlan& plan, double mean);
  void sweep(DevicePlan plan);
  void slide(DevicePlan plan, const SlabLaw& law);

  Device& device_;
  int sweeps_;
  PolledRows polled_rows_;  // of the round under way
  WindFrame frame_;
  bool open_ = false;
  bool relief_ = false;
  std::int32_t base_ = 0;  // lowest bedrock
  std::int64_t bedrock_total_ = 0;
  std::int64_t mobile_total_ = 0;
  std::uint64_t cover_stamp_ = 0;  // of the cover that is loaded; 0: none
  int current_ = 0;                // which of the two bounds belongs to before_

  DeviceArray<std::uint32_t> before_;
  DeviceArray<std::uint32_t> after_;
  DeviceArray<std::uint16_t> bedrock_;
  DeviceArray<std::uint8_t> cover_;
  DeviceArray<std::uint8_t> dark_;
  DeviceArray<std::int32_t> staged_;
  DeviceArray<std::int32_t> shown_;
  DeviceArray<std::int32_t> lift_counts_;  // empty unless they are wanted
  DeviceArray<std::uint32_t> bands_changed_;
  DeviceArray<std::int32_t> first_aloft_;
  DeviceArray<SlabAloft> aloft_;
  DeviceArray<std::int32_t> aloft_count_;
  DeviceArray<std::uint32_t> highest_;
  DeviceArray<std::uint32_t> hop_table_;
  DeviceArray<std::uint32_t> height_counts_;
  DeviceArray<TallyWord> tally_;
};

}  // namespace erg
