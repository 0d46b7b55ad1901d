// Kernels that bring the terrain in and out, and that prepare a step: one thread, one cell (or one height).
#pragma once

#include "cuda/device_cells.h"

namespace erg::ERG_KERNEL_SPACE {

/// A layer from the terrain's order into the frame's.
__global__ void lay_layer(LayerPlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells; cell += item_stride()) {
    plan.layer[cell] = plan.staged[plan.order.place(cell)];
  }
}

/// The same way back.
__global__ void stage_layer(LayerPlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells; cell += item_stride()) {
    plan.staged[plan.order.place(cell)] = plan.layer[cell];
  }
}

/// Heights over the lowest bedrock, from the terrain's order.
__global__ void lay_surface(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    plan.before[cell] = static_cast<std::uint32_t>(plan.staged[plan.order.place(cell)]);
  }
}

__global__ void lay_bedrock(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    plan.bedrock[cell] = static_cast<std::uint16_t>(plan.staged[plan.order.place(cell)]);
  }
}

/// Cover comes in as bytes.
__global__ void lay_cover(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    plan.cover[cell] = reinterpret_cast<const std::uint8_t*>(plan.staged)[plan.order.place(cell)];
  }
}

/// Shows the processor what has changed.
__global__ void show_surface(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    const std::ptrdiff_t place = plan.order.place(cell);
    const auto height = static_cast<std::int32_t>(height_of(plan.before[cell]));
    if (plan.shown[place] == height) continue;
    plan.shown[place] = height;
    raise(plan.bands_changed + place / band_cells, 1);
  }
}

/// The same ways back, for a turn.
__global__ void stage_surface(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    plan.staged[plan.order.place(cell)] = static_cast<std::int32_t>(height_of(plan.before[cell]));
  }
}

__global__ void stage_bedrock(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    plan.staged[plan.order.place(cell)] = plan.bedrock[cell];
  }
}

/// How many cells have each height.
__global__ void count_heights(DevicePlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cells(); cell += item_stride()) {
    atomicAdd(plan.height_counts + height_of(plan.before[cell]), std::uint32_t{1});
  }
}

/// Hops from ground of every height.
__global__ void fill_hop_table(DevicePlan plan) {
  const std::int32_t heights = plan.hop_by_height ? device_heights : 1;
  for (std::int32_t height = first_item(); height < heights; height += item_stride()) {
    plan.hop_table[height] = hop_rows_256(plan.hop, static_cast<double>(height) - plan.hop_reference);
  }
}

}  // namespace erg::ERG_KERNEL_SPACE
