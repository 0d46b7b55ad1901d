// The reference flights of SnowMachine: one slab after another in random order, each seeing what the last one left.
#include <algorithm>
#include <numeric>
#include <utility>

#include "models/slab/slab_cell.h"
#include "models/snow/snow_machine.h"

namespace erg {
namespace {

/// What the random words of these flights are for; each has a key space of its own.
enum FlightWord : std::uint64_t { flights = 60, drift = 61, shuffles = 65 };

}  // namespace

/// The reference: each slab sees what the last one left.
void SnowMachine::fly_one_by_one() {
  let_drift_enter();
  const std::size_t cells = extent_.cells();
  order_.resize(cells);
  std::iota(order_.begin(), order_.end(), 0u);
  for (std::size_t last = cells - 1; last > 0; --last) {
    std::swap(order_[last], order_[random_below(key_, 0, last, shuffles, static_cast<std::uint32_t>(last + 1))]);
  }
  const std::uint64_t base = random_word(key_, 0, 0, flights);
  for (const std::uint32_t number : order_) {
    const int u = static_cast<int>(number / static_cast<std::uint32_t>(frame_.length));
    const int v = static_cast<int>(number % static_cast<std::uint32_t>(frame_.length));
    poll({u, v}, snow_cell_word(base, number));
  }
}

void SnowMachine::poll(Place place, std::uint64_t word) {
  const std::size_t here = cell(place.u, place.v);
  std::int32_t& loose = layers_->loose[here];
  const std::uint32_t snow = snow_word(std::min(loose, 1), std::min(mobile_[here], 1));
  if ((word & 0xffff) >= lift_chance_of(snow, chances_[here])) return;
  ++report_.lifts;
  if (Grid<std::int32_t>* const counts = executor_->lift_counts()) ++(*counts)[here];
  --mobile_[here];
  if (loose > 0) --loose;
  fly(place, word, false);
}

/// A slab in the air, from hop to hop. One that enters over an edge begins somewhere in its first hop.
void SnowMachine::fly(Place place, std::uint64_t word, bool enters) {
  const SnowLaw& law = *law_;
  const auto tangent_24 = static_cast<std::int64_t>(frame_.tangent * 0x1p24);
  const auto sideways = static_cast<std::int64_t>(word >> 40);
  const int first_u = place.u;
  const int limit = longest_flight * frame_.length;
  int flown = 0;
  const auto leave = [&](int rows) {
    report_.travel += rows;
    ++report_.slabs_out;
  };
  const auto land = [&](std::size_t here) {
    report_.travel += flown;
    ++mobile_[here];
    ++layers_->loose[here];
    layers_->landed[here] = law.now;
  };
  while (true) {
    word = mix64(word);
    const std::size_t start = cell(place.u, place.v);
    const int height = flying_height(over_[start], law.clearance_16);
    int rows = snow_hop_rows(hops_[start], static_cast<std::uint32_t>(word));
    if (enters) rows = std::max(1, static_cast<int>(static_cast<float>(rows) * unit_24(word >> 40)));
    enters = false;
    std::size_t from = start;
    std::size_t here = start;
    int row = 0;
    while (row < rows) {
      int u = first_u + static_cast<int>(((flown + row + 1) * tangent_24 + sideways) >> 24);
      int v = place.v + 1;
      if (!ground_.fold(u, v)) return leave(flown + row);
      if (bedrock_[cell(u, v)] - surface(here) > law.wall) {
        flown += row;
        return land(here);
      }
      from = here;
      place = {u, v};
      here = cell(u, v);
      ++row;
      if (over_[here] > height) break;
    }
    flown += row;
    const bool hard = layers_->loose[here] <= 0;
    const bool snow = mobile_[here] > 0;
    const auto random = static_cast<std::uint32_t>(word >> 32) * 0x9e3779b1u >> 8;
    if (hard && snow && strikes(here, from, static_cast<float>(row) / static_cast<float>(rows), random)) {
      ++layers_->loose[here];
    }
    const bool dark = mean_hop_64(hops_[here]) == 0;
    const float rest = dark ? 1 : (!hard ? law.rest_loose : (snow ? law.rest_hard : law.rest_ground));
    const std::uint64_t draws = mix64(word ^ 0x5851f42d4c957f2du);
    if (unit_24(static_cast<std::uint32_t>(draws)) < rest || flown >= limit) return land(here);
    if (law.suspension > 0 && unit_24(static_cast<std::uint32_t>(draws >> 32)) < law.suspension) return leave(flown);
  }
}

/// Whether an impact on bonded snow frees a slab of it in place.
bool SnowMachine::strikes(std::size_t here, std::size_t from, float flown, std::uint32_t random) const {
  const auto rise = static_cast<float>(surface(here) - surface(from));
  const float power = abrasion_of(hops_[here]) * impact_share(*law_, rise) * flown;
  const float drawn = unit_24(random);
  if (!may_free(*law_, drawn, power)) return false;
  const int x = static_cast<int>(here % static_cast<std::size_t>(extent_.nx));
  const int y = static_cast<int>(here / static_cast<std::size_t>(extent_.nx));
  return drawn * snow_strength(*law_, x, y, mobile_[here]) < power;
}

/// Open boundary: drift comes in over the upwind edges.
void SnowMachine::let_drift_enter() {
  if (inflow_ <= 0) return;
  const std::uint64_t base = random_word(key_, 0, 0, drift);
  std::uint64_t count = 0;
  const auto enter = [&](int u, int v, double rate) {
    std::uint64_t word = snow_cell_word(base, count++);
    const int slabs = static_cast<int>(rate + static_cast<double>(word >> 11) * 0x1.0p-53);
    for (int slab = 0; slab < slabs; ++slab) {
      word = mix64(word);
      ++report_.slabs_in;
      fly({u, v}, word, true);
    }
  };
  for (int u = 0; u < frame_.width; ++u) enter(u, 0, inflow_);
  if (frame_.tangent > 0) {
    for (int v = 0; v < frame_.length; ++v) enter(0, v, inflow_ * frame_.tangent);
  }
}

}  // namespace erg
