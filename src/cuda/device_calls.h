// The few calls of the CUDA runtime that the executor makes, one to one, so that tests can stand in for them on a
// machine without a graphics card, and make any of them fail. Each returns 0 or an error number.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace erg {

struct DevicePlan;
struct GrainPlan;
struct LayerPlan;
struct SnowPlan;

/// The kernels, as those who launch them name them.
enum class DeviceKernel {
  lay_surface,
  lay_bedrock,
  lay_cover,
  show_surface,
  stage_surface,
  stage_bedrock,
  count_heights,
  fill_hop_table,
  cast_shadow,
  let_in,
  lift,
  carry,
  slide_tiles,
  slide_row_seams,
  slide_column_seams,
  slide_corners
};

/// Those that turn a layer into the wind's frame, and back.
enum class LayerKernel { lay, stage };

/// Those of grains.
enum class GrainKernel { freeze, shadow, rim, fly, let_in, hand_out, settle_accounts, slide, creep, bond };

/// Those of sintering snow.
enum class SnowKernel {
  measure,
  sum_heights,
  sum_columns,
  sum_rows,
  average_rows,
  shadow,
  weather,
  find_walls,
  find_runs,
  fly,
  bring_down,
  store,
  slide,
  fall,
  rest,
  show_strength
};

/// Threads in a block of every launch.
inline constexpr int device_block = 256;

class DeviceCalls {
 public:
  using Status = int;
  virtual ~DeviceCalls() = default;

  virtual Status count_devices(int& count) = 0;
  virtual Status choose_device(int number) = 0;
  virtual Status name_device(int number, std::string& name) = 0;
  virtual std::string error_text(Status status) = 0;

  virtual Status allocate(void*& memory, std::size_t bytes) = 0;
  virtual void release(void* memory) = 0;
  virtual Status allocate_pinned(void*& memory, std::size_t bytes) = 0;
  virtual void release_pinned(void* memory) = 0;

  virtual Status create_stream(void*& stream) = 0;
  virtual void destroy_stream(void* stream) = 0;
  virtual Status wait_for_stream(void* stream) = 0;
  virtual Status create_event(void*& event) = 0;
  virtual void destroy_event(void* event) = 0;
  virtual Status record(void* event, void* stream) = 0;
  virtual Status wait_for_event(void* event) = 0;

  /// Copies between pinned and device memory; return before they are done.
  virtual Status copy_in(void* device, const void* pinned, std::size_t bytes, void* stream) = 0;
  virtual Status copy_out(void* pinned, const void* device, std::size_t bytes, void* stream) = 0;
  virtual Status fill(void* device, int byte, std::size_t bytes, void* stream) = 0;
  virtual Status launch(DeviceKernel kernel, int blocks, const DevicePlan& plan, void* stream) = 0;
  virtual Status launch(LayerKernel kernel, int blocks, const LayerPlan& plan, void* stream) = 0;
  virtual Status launch(GrainKernel kernel, int blocks, const GrainPlan& plan, void* stream) = 0;
  virtual Status launch(SnowKernel kernel, int blocks, const SnowPlan& plan, void* stream) = 0;
};

/// The real ones; null where Erg was built without CUDA.
std::unique_ptr<DeviceCalls> cuda_calls();

}  // namespace erg
