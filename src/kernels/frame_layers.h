// FrameLayers of a terrain in a back end's memory: words of 32 bits, whole numbers or floats, in the wind's frame. They
// come in and go out in the terrain's order, through a staging layer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "compute/backend.h"
#include "core/grid.h"
#include "forcing/wind_frame.h"
#include "kernels/layer_kernels.h"

namespace erg::kernels {

using FrameLayer = compute::Buffer<std::int32_t>;

class FrameLayers {
 public:
  explicit FrameLayers(compute::Backend& backend) : backend_(backend) {}

  /// Makes room for `cells` cells. This and all that follows throws DeviceError.
  void fit(std::size_t cells) { backend_.fit(staged_, cells); }
  /// Sends value(cell) of each of the terrain's cells to a layer.
  template <typename Value>
  void scatter(const FrameLayer& layer, const forcing::WindFrame& frame, const Value& value) {
    backend_.send_each(staged_, value);
    move(layer::Kernels::scatter, layer, frame);
  }
  /// A layer in the terrain's order.
  std::vector<std::int32_t> gather(const FrameLayer& layer, const forcing::WindFrame& frame) {
    move(layer::Kernels::gather, layer, frame);
    return backend_.fetch(staged_.data(), staged_.size());
  }
  /// Adds a layer to numbers in the terrain's order.
  void add_to(Grid<std::int32_t>& sums, const FrameLayer& layer, const forcing::WindFrame& frame) {
    const std::vector<std::int32_t> numbers = gather(layer, frame);
    for (std::size_t cell = 0; cell < numbers.size(); ++cell) sums[cell] += numbers[cell];
  }
  /// Lays layers out for a wind from another side.
  void turn(const std::vector<const FrameLayer*>& layers, const forcing::WindFrame& from,
            const forcing::WindFrame& to) {
    for (const FrameLayer* layer : layers) {
      move(layer::Kernels::gather, *layer, from);
      move(layer::Kernels::scatter, *layer, to);
    }
  }
  /// The staging layer, for other use in between.
  const FrameLayer& staged() const { return staged_; }

 private:
  void move(const compute::KernelOf<layer::Plan>& kernel, const FrameLayer& layer, const forcing::WindFrame& frame) {
    const auto cells = static_cast<std::int32_t>(staged_.size());
    backend_.launch(kernel, cells, layer::Plan{terrain_order(frame), cells, staged_.data(), layer.data()});
  }

  compute::Backend& backend_;
  FrameLayer staged_;
};

}  // namespace erg::kernels
