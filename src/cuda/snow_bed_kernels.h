// Kernels of sintering snow that lies: slides, snowfall, bonding. One thread, one cell or edge.
#pragma once

#include "cuda/device_cells.h"
#include "cuda/snow_plan.h"

namespace erg::ERG_KERNEL_SPACE {

/// Edges of one class: they share no cell, so nobody waits for anybody.
__global__ void snow_slide(SnowPlan plan) {
  const SnowEdgeClass& edges = plan.edges;
  const std::int32_t places = edges.along ? plan.width() : plan.length();
  const std::int32_t end = edges.along ? plan.length() : plan.width();
  for (std::int32_t item = first_item(); item < edges.count * places; item += item_stride()) {
    const std::int32_t number = edges.along ? item / places : item % edges.count;
    const std::int32_t place = edges.along ? item % places : item / edges.count;
    const std::int32_t from = edges.closes ? end - 1 : 2 * number + edges.odd;
    const std::int32_t to = edges.closes ? 0 : from + 1;
    const std::size_t a = edges.along ? plan.ground.cell(place, from) : plan.ground.cell(from, place);
    const std::size_t b = edges.along ? plan.ground.cell(place, to) : plan.ground.cell(to, place);
    slide_snow(plan.ground, a, b, *plan.law);
  }
}

/// Snow falls at random. Where it comes to rest is looked for on the ground before any of it has come down.
__global__ void snow_fall(SnowPlan plan) {
  ThreadTally tally;
  for (std::int32_t cell = first_item(); cell < plan.cell_count(); cell += item_stride()) {
    const std::int32_t u = cell % plan.width();
    const std::int32_t v = cell / plan.width();
    const std::uint64_t word = snow_cell_word(plan.fall_word, plan.ground.number(u, v));
    const int slabs = falling_slabs(*plan.law, word);
    if (slabs == 0) continue;
    atomicAdd(plan.fallen + lowest_of_nine(plan.ground, u, v, word), slabs);
    tally.counts[tally_in] += slabs;
  }
  tally.book(plan.tally);
}

/// What has fallen lies; loose snow bonds from below; bonded snow grows older.
__global__ void snow_rest(SnowPlan plan) {
  const SnowLaw& law = *plan.law;
  const SnowGround& ground = plan.ground;
  for (std::int32_t cell = first_item(); cell < plan.cell_count(); cell += item_stride()) {
    const std::int32_t fallen = plan.fallen != nullptr ? plan.fallen[cell] : 0;
    const std::int32_t mobile = ground.mobile[cell] + fallen;
    const float landed = fallen > 0 ? law.now : ground.landed[cell];
    const auto number = static_cast<std::uint32_t>(ground.number(cell % plan.width(), cell / plan.width()));
    const RestingSnow before{mobile, ground.loose[cell] + fallen, plan.age[cell], law.now - landed};
    const RestingSnow after = rested(law, before, mix32(plan.bonding_key + number * 0x9e3779b9u));
    ground.mobile[cell] = mobile;
    ground.loose[cell] = after.loose;
    ground.landed[cell] = landed;
    plan.age[cell] = after.age;
  }
}

/// Strength of the uppermost bonded snow.
__global__ void snow_show_strength(SnowPlan plan) {
  for (std::int32_t cell = first_item(); cell < plan.cell_count(); cell += item_stride()) {
    const auto place = static_cast<std::int32_t>(plan.order.place(cell));
    const std::int32_t bonded = plan.ground.mobile[cell] - plan.ground.loose[cell];
    plan.strength[cell] = snow_strength(*plan.law, place % plan.nx, place / plan.nx, bonded);
  }
}

}  // namespace erg::ERG_KERNEL_SPACE
