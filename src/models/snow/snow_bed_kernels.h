// Kernels of sintering snow that lies: slides, snowfall, bonding. One thread, one cell or edge.
#pragma once

#include "compute/kernel.h"
#include "models/snow/plan.h"

namespace erg::models::snow {

/// Edges of one class: they share no cell, so nobody waits for anybody.
ERG_ON_DEVICE void slide(const SnowPlan& plan, compute::Items items) {
  const SnowEdgeClass& edges = plan.edges;
  const std::int32_t places = edges.along ? plan.width() : plan.length();
  const std::int32_t end = edges.along ? plan.length() : plan.width();
  EACH_ITEM(item, edges.count * places) {
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
ERG_ON_DEVICE void fall(const SnowPlan& plan, compute::Items items) {
  kernels::StepCounters counted;
  EACH_ITEM(cell, plan.cell_count()) {
    const std::int32_t u = cell % plan.width();
    const std::int32_t v = cell / plan.width();
    const std::uint64_t word = snow_cell_word(plan.fall_word, plan.ground.number(u, v));
    const int slabs = falling_slabs(*plan.law, word);
    if (slabs == 0) continue;
    compute::atomic_add(plan.fallen + lowest_of_nine(plan.ground, u, v, word), slabs);
    counted.of[kernels::counted_in] += slabs;
  }
  counted.add_to(plan.counters, items);
}

/// What has fallen lies; loose snow bonds from below; bonded snow grows older.
ERG_ON_DEVICE void rest(const SnowPlan& plan, compute::Items items) {
  const SnowLaw& law = *plan.law;
  const SnowGround& ground = plan.ground;
  EACH_ITEM(cell, plan.cell_count()) {
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
ERG_ON_DEVICE void show_strength(const SnowPlan& plan, compute::Items items) {
  EACH_ITEM(cell, plan.cell_count()) {
    const auto place = static_cast<std::int32_t>(plan.order.place(cell));
    const std::int32_t bonded = plan.ground.mobile[cell] - plan.ground.loose[cell];
    plan.strength[cell] = snow_strength(*plan.law, place % plan.nx, place / plan.nx, bonded);
  }
}

}  // namespace erg::models::snow
