// Layers of a terrain on a device: words of 32 bits, whole numbers or floats, in the wind's frame. They come in and go
// out in the terrain's order, through a staging layer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/grid.h"
#include "cuda/device.h"
#include "cuda/device_plan.h"
#include "forcing/wind_frame.h"

namespace erg {

using DeviceLayer = DeviceArray<std::int32_t>;

class DeviceLayers {
 public:
  explicit DeviceLayers(Device& device) : device_(device) {}

  /// Makes room for `cells` cells. This and all that follows throws DeviceError.
  void fit(std::size_t cells) { device_.fit(staged_, cells); }
  /// Sends value(cell) of each of the terrain's cells to a layer.
  template <typename Value>
  void lay(const DeviceLayer& layer, const WindFrame& frame, const Value& value) {
    device_.send_each(staged_, value);
    move(LayerKernel::lay, layer, frame);
  }
  /// A layer in the terrain's order.
  std::vector<std::int32_t> bring_back(const DeviceLayer& layer, const WindFrame& frame) {
    move(LayerKernel::stage, layer, frame);
    return device_.fetch(staged_.data(), staged_.size());
  }
  /// Adds a layer to numbers in the terrain's order.
  void add_to(Grid<std::int32_t>& sums, const DeviceLayer& layer, const WindFrame& frame) {
    const std::vector<std::int32_t> numbers = bring_back(layer, frame);
    for (std::size_t cell = 0; cell < numbers.size(); ++cell) sums[cell] += numbers[cell];
  }
  /// Lays layers out for a wind from another side.
  void turn(const std::vector<const DeviceLayer*>& layers, const WindFrame& from, const WindFrame& to) {
    for (const DeviceLayer* layer : layers) {
      move(LayerKernel::stage, *layer, from);
      move(LayerKernel::lay, *layer, to);
    }
  }
  /// The staging layer, for other use in between.
  const DeviceLayer& staged() const { return staged_; }

 private:
  void move(LayerKernel kernel, const DeviceLayer& layer, const WindFrame& frame) {
    const auto cells = static_cast<std::int32_t>(staged_.size());
    device_.launch(kernel, cells, LayerPlan{terrain_order(frame), cells, staged_.data(), layer.data()});
  }

  Device& device_;
  DeviceLayer staged_;
};

}  // namespace erg
