#include "models/snow/snow_one_by_one.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "models/slab/slab_cell.h"

namespace erg::models {

using forcing::WindFrame;

namespace {

/// What the random words of these flights are for; each has a key space of its own.
enum FlightWord : std::uint64_t { flights = 60, drift = 61, shuffles = 65 };

class OneByOne {
 public:
  OneByOne(const SnowPlanes& planes, const SnowGround& ground, const WindFrame& frame)
      : planes_(planes), law_(*planes.law), ground_(ground), frame_(frame) {}

  void let_drift_enter(StepKey key);
  void poll_all(StepKey key);
  const StepReport& report() const { return report_; }

 private:
  /// A cell of the wind's frame.
  struct Spot {
    int u;
    int v;
  };

  void poll(Spot spot, std::uint64_t word);
  void fly(Spot spot, std::uint64_t word, bool enters);
  void land(std::size_t here, int flown);
  void leave(int flown);
  bool strikes(Spot spot, std::size_t from, float flown, std::uint32_t random) const;
  std::size_t cell(Spot spot) const { return ground_.cell(spot.u, spot.v); }
  std::size_t place(Spot spot) const {
    return static_cast<std::size_t>(planes_.origin + spot.u * planes_.step_u + spot.v * planes_.step_v);
  }
  std::uint32_t hops(Spot spot) const {
    return mean_hop_64(planes_.cells[place(spot)].way) | std::uint32_t{planes_.powers[place(spot)]} << 16;
  }

  const SnowPlanes& planes_;
  const SnowLaw& law_;
  const SnowGround& ground_;
  const WindFrame& frame_;
  StepReport report_;
};

void OneByOne::poll_all(StepKey key) {
  std::vector<std::uint32_t> order(static_cast<std::size_t>(ground_.width) * static_cast<std::size_t>(ground_.length));
  std::iota(order.begin(), order.end(), 0u);
  for (std::size_t last = order.size() - 1; last > 0; --last) {
    std::swap(order[last], order[random_below(key, 0, last, shuffles, static_cast<std::uint32_t>(last + 1))]);
  }
  const std::uint64_t base = random_word(key, 0, 0, flights);
  for (const std::uint32_t number : order) {
    const auto length = static_cast<std::uint32_t>(ground_.length);
    poll({static_cast<int>(number / length), static_cast<int>(number % length)}, snow_cell_word(base, number));
  }
}

void OneByOne::poll(Spot spot, std::uint64_t word) {
  const std::size_t here = cell(spot);
  std::int32_t& loose = ground_.loose[here];
  const std::uint32_t snow = snow_word(std::min(loose, 1), std::min(ground_.mobile[here], 1));
  if ((word & 0xffff) >= lift_chance_of(snow, planes_.chances[place(spot)])) return;
  ++report_.lifts;
  if (planes_.lift_counts != nullptr) ++planes_.lift_counts[here];
  --ground_.mobile[here];
  if (loose > 0) --loose;
  fly(spot, word, false);
}

void OneByOne::leave(int flown) {
  report_.travel += flown;
  ++report_.slabs_out;
}

void OneByOne::land(std::size_t here, int flown) {
  report_.travel += flown;
  ++ground_.mobile[here];
  ++ground_.loose[here];
  ground_.landed[here] = law_.now;
}

/// A slab in the air, from hop to hop. One that enters over an edge begins somewhere in its first hop.
void OneByOne::fly(Spot spot, std::uint64_t word, bool enters) {
  const auto tangent_24 = static_cast<std::int64_t>(frame_.tangent * 0x1p24);
  const auto sideways = static_cast<std::int64_t>(word >> 40);
  const int first_u = spot.u;
  const int limit = longest_flight * ground_.length;
  int flown = 0;
  while (true) {
    word = mix64(word);
    const int height = flying_height(planes_.over[place(spot)], law_.clearance_16);
    int rows = snow_hop_rows(hops(spot), static_cast<std::uint32_t>(word));
    if (enters) rows = std::max(1, static_cast<int>(static_cast<float>(rows) * unit_24(word >> 40)));
    enters = false;
    std::size_t from = cell(spot);
    int row = 0;
    while (row < rows) {
      Spot next{first_u + static_cast<int>(((flown + row + 1) * tangent_24 + sideways) >> 24), spot.v + 1};
      if (!ground_.fold(next.u, next.v)) return leave(flown + row);
      if (ground_.bedrock[cell(next)] - ground_.surface(cell(spot)) > law_.wall) return land(cell(spot), flown + row);
      from = cell(spot);
      spot = next;
      ++row;
      if (planes_.over[place(spot)] > height) break;
    }
    flown += row;
    const std::size_t here = cell(spot);
    const bool hard = ground_.loose[here] <= 0;
    const bool snow = ground_.mobile[here] > 0;
    const auto random = static_cast<std::uint32_t>(word >> 32) * 0x9e3779b1u >> 8;
    if (hard && snow && strikes(spot, from, static_cast<float>(row) / static_cast<float>(rows), random)) {
      ++ground_.loose[here];
    }
    const bool dark = mean_hop_64(hops(spot)) == 0;
    const float rest = dark ? 1 : (!hard ? law_.rest_loose : (snow ? law_.rest_hard : law_.rest_ground));
    const std::uint64_t draws = mix64(word ^ 0x5851f42d4c957f2du);
    if (unit_24(static_cast<std::uint32_t>(draws)) < rest || flown >= limit) return land(here, flown);
    if (law_.suspension > 0 && unit_24(static_cast<std::uint32_t>(draws >> 32)) < law_.suspension) return leave(flown);
  }
}

/// Whether an impact on bonded snow frees a slab of it in place.
bool OneByOne::strikes(Spot spot, std::size_t from, float flown, std::uint32_t random) const {
  const std::size_t here = cell(spot);
  const auto rise = static_cast<float>(ground_.surface(here) - ground_.surface(from));
  const float power = abrasion_of(hops(spot)) * impact_share(law_, rise) * flown;
  const float drawn = unit_24(random);
  if (!may_free(law_, drawn, power)) return false;
  const int x = static_cast<int>(here % static_cast<std::size_t>(planes_.nx));
  const int y = static_cast<int>(here / static_cast<std::size_t>(planes_.nx));
  return drawn * snow_strength(law_, x, y, ground_.mobile[here]) < power;
}

/// Open boundary: drift comes in over the upwind edges.
void OneByOne::let_drift_enter(StepKey key) {
  if (planes_.inflow <= 0) return;
  const std::uint64_t base = random_word(key, 0, 0, drift);
  std::uint64_t count = 0;
  const auto enter = [&](Spot spot, double rate) {
    std::uint64_t word = snow_cell_word(base, count++);
    const int slabs = static_cast<int>(rate + static_cast<double>(word >> 11) * 0x1.0p-53);
    for (int slab = 0; slab < slabs; ++slab) {
      word = mix64(word);
      ++report_.slabs_in;
      fly(spot, word, true);
    }
  };
  for (int u = 0; u < ground_.width; ++u) enter({u, 0}, planes_.inflow);
  for (int v = 0; v < ground_.length && frame_.tangent > 0; ++v) enter({0, v}, planes_.inflow * frame_.tangent);
}

}  // namespace

StepReport fly_one_by_one(const SnowPlanes& planes, const SnowGround& ground, const WindFrame& frame, StepKey key) {
  OneByOne flights(planes, ground, frame);
  flights.let_drift_enter(key);
  flights.poll_all(key);
  return flights.report();
}

}  // namespace erg::models
