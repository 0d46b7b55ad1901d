#include "models/slab/reference.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "kernels/fixed_point.h"
#include "kernels/shadow.h"
#include "kernels/shadow_reach.h"
#include "models/slab/terrain_heights.h"

namespace erg::models {

using forcing::WindFrame;
using kernels::fixed_point;
using kernels::fixed_point_bits;

namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// What the random words of a step are for; each has a key space of its own.
enum SlabWord : std::uint64_t { of_polls, of_slabs, of_shuffles, of_inflow };

struct Offset {
  int u;
  int v;
  bool diagonal;
};
// Ties between equal slopes go downwind first for a slab that slides and upwind first for one that is missed (Cimbura
// 2022, fig. 5.5).
constexpr Offset downwind_first[] = {{0, 1, false}, {1, 0, false}, {-1, 0, false}, {0, -1, false},
                                     {1, 1, true},  {-1, 1, true}, {1, -1, true},  {-1, -1, true}};
constexpr Offset upwind_first[] = {{0, -1, false}, {1, 0, false},  {-1, 0, false}, {0, 1, false},
                                   {1, -1, true},  {-1, -1, true}, {1, 1, true},   {-1, 1, true}};

}  // namespace

std::uint64_t SlabReference::Draws::next() { return mix64(base + 0x9e3779b97f4a7c15u * ++count); }

StepReport SlabReference::step(Terrain& terrain, const SlabLaw& law, const WindFrame& frame, double strength,
                               StepKey key, Grid<std::int32_t>* lift_counts) {
  if (!frame_.same_axes(frame)) {
    sync_to_host(terrain);
    load(terrain, frame);
  }
  frame_ = frame;
  law_ = law;
  strength_ = strength;
  key_ = key;
  lift_counts_ = lift_counts;
  report_ = {};
  prepare(law);
  let_inflow_enter();

  const auto cells = static_cast<std::int64_t>(surface_.size());
  const std::int64_t patience = 4 * cells;  // polls without a lift before forced erosion looks whether any can come
  std::int64_t last_lift = 0;
  for (std::int64_t poll = 0; law_.forced_erosion ? report_.lifts < cells : poll < cells; ++poll) {
    Draws draws{random_word(key_, 0, static_cast<std::uint64_t>(poll), of_slabs)};
    ++report_.polls;
    if (lift(polled_cell(poll), draws)) {
      last_lift = poll;
    } else if (law_.forced_erosion && poll - last_lift > patience) {
      if (!anything_can_move(draws)) break;
      last_lift = poll;
    }
  }
  return report_;
}

void SlabReference::load(const Terrain& terrain, const WindFrame& frame) {
  const TerrainHeights heights = check_height(terrain);
  lowest_ = heights.lowest;
  has_relief_ = heights.relief;
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  frame_ = frame;
  surface_.resize(mobile.size());
  bedrock_.resize(mobile.size());
  for (int u = 0; u < frame.width; ++u) {
    for (int v = 0; v < frame.length; ++v) {
      const std::size_t from = frame.cell(u, v);
      bedrock_[index(u, v)] = static_cast<std::uint16_t>(bedrock[from] - lowest_);
      surface_[index(u, v)] = static_cast<std::uint16_t>(bedrock[from] - lowest_ + mobile[from]);
    }
  }
  open_ = terrain.boundary() == Boundary::open;
  count_heights();
}

void SlabReference::sync_to_host(Terrain& terrain) {
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  for (int u = 0; u < frame_.width; ++u) {
    for (int v = 0; v < frame_.length; ++v) mobile[frame_.cell(u, v)] = surface_[index(u, v)] - bedrock_[index(u, v)];
  }
}

void SlabReference::prepare(const SlabLaw& law) {
  const kernels::ShadowFalls falls = kernels::shadow_falls(frame_, law.shadow_fall);
  row_fall_ = fixed_point(falls.row);
  next_fall_ = fixed_point(falls.next);
  second_fall_ = fixed_point(falls.second);
  measure_relief();
  cover_.clear();
  if (law.cover == nullptr) return;
  cover_.resize(surface_.size());
  for (int u = 0; u < frame_.width; ++u) {
    for (int v = 0; v < frame_.length; ++v) cover_[index(u, v)] = (**law.cover)[frame_.cell(u, v)];
  }
}

void SlabReference::count_heights() {
  highest_ = *std::max_element(surface_.begin(), surface_.end());
  height_count_.assign(static_cast<std::size_t>(highest_) + 1, 0);
  for (const std::uint16_t height : surface_) ++height_count_[height];
}

/// Mean and deviation afresh for each step, summed in the order of heights: a resumed run starts from the same bits.
void SlabReference::measure_relief() {
  std::int64_t sum = 0;
  for (std::size_t k = 0; k < height_count_.size(); ++k) {
    sum += height_count_[k] * static_cast<std::int64_t>(k);
  }
  mean_ = static_cast<double>(sum) / static_cast<double>(surface_.size());
  deviation_ = 0;
  for (std::size_t k = 0; k < height_count_.size(); ++k) {
    deviation_ += static_cast<double>(height_count_[k]) * std::abs(static_cast<double>(k) - mean_);
  }
}

/// The cell that poll number `poll` of this step asks for a slab.
std::size_t SlabReference::polled_cell(std::int64_t poll) {
  const auto cells = static_cast<std::int64_t>(surface_.size());
  if (law_.repeated_polling) {
    return random_below(key_, 0, static_cast<std::uint64_t>(poll), of_polls, static_cast<std::uint32_t>(cells));
  }
  if (poll % cells == 0) shuffle(static_cast<std::uint64_t>(poll / cells));
  return order_[static_cast<std::size_t>(poll % cells)];
}

void SlabReference::shuffle(std::uint64_t round) {
  order_.resize(surface_.size());
  std::iota(order_.begin(), order_.end(), 0u);
  for (std::size_t last = order_.size() - 1; last > 0; --last) {
    const std::uint32_t other = random_below(key_, 1 + round, last, of_shuffles, static_cast<std::uint32_t>(last + 1));
    std::swap(order_[last], order_[other]);
  }
}

bool SlabReference::anything_can_move(Draws draws) {
  for (int u = 0; u < frame_.width; ++u) {
    for (int v = 0; v < frame_.length; ++v) {
      const std::size_t cell = index(u, v);
      if (surface_[cell] == ground(cell) || (!cover_.empty() && cover_[cell] == 255)) continue;
      if (law_.lift_in_shadow || !in_shadow({u, v}, draws)) return true;
    }
  }
  return false;
}

/// Algorithm 2/3 and 4: lifts a slab from the cell, or from the top of the slope that would slide into the gap.
bool SlabReference::lift(std::size_t cell, Draws& draws) {
  if (surface_[cell] == ground(cell)) return false;
  const Place start = place_of(cell);
  if (!cover_.empty() && draws.unit() * 255 < cover_[cell]) return false;
  if (!law_.lift_in_shadow && in_shadow(start, draws)) return false;
  ++report_.lifts;
  if (lift_counts_ != nullptr) ++(*lift_counts_)[frame_.cell(start.u, start.v)];
  const int hop = hop_rows(surface_[cell], draws);
  if (hop == 0) return true;  // it lies where it lay
  std::size_t source = cell;
  Place place = start;
  for (std::size_t next = steepest_neighbour(place, true); next != nowhere; next = steepest_neighbour(place, true)) {
    source = next;
    place = place_of(next);
  }
  change(source, -1);
  fly(start, hop, draws);
  return true;
}

/// The neighbour to which (down) or from which (up) the ground is steepest, if steeper than what stands; else
/// `nowhere`.
std::size_t SlabReference::steepest_neighbour(Place place, bool uphill) const {
  const std::size_t here = index(place.u, place.v);
  std::size_t steepest = nowhere;
  double best = 0;
  for (int k = 0; k < law_.neighbours; ++k) {
    const Offset& offset = uphill ? upwind_first[k] : downwind_first[k];
    int u = place.u + offset.u;
    int v = place.v + offset.v;
    if (!inside(u, v)) continue;
    const std::size_t there = index(u, v);
    const std::size_t higher = uphill ? there : here;
    const int difference = 1 + (uphill ? surface_[there] - surface_[here] : surface_[here] - surface_[there]);
    const ReposeSteps& steps = covered(higher) ? law_.covered : law_.bare;
    if (difference <= (offset.diagonal ? steps.diagonal : steps.straight)) continue;
    if (uphill && surface_[there] == ground(there)) continue;  // bare rock has nothing to give
    const double slope = offset.diagonal ? difference / std::sqrt(2.0) : difference;
    if (slope > best) {
      best = slope;
      steepest = there;
    }
  }
  return steepest;
}

/// A slab in the air: hops until it stays, meets an obstacle or leaves over an open edge (algorithms 2, 3 and 7).
void SlabReference::fly(Place place, int hop, Draws& draws) {
  const double sideways = frame_.tangent > 0 ? draws.unit() : 0;
  const int first_u = place.u;
  const int flight_limit = longest_flight * frame_.length;
  int rows = 0;
  const auto sideways_at = [&](int row) {
    return first_u + static_cast<int>(std::floor(row * frame_.tangent + sideways));
  };
  while (true) {
    const int target = rows + std::max(1, hop);
    while (rows < target) {
      int u = sideways_at(rows + 1);
      int v = place.v + 1;
      const std::size_t from = index(place.u, place.v);
      if (!inside(u, v)) {
        ++report_.slabs_out;
        report_.travel += rows / frame_.cosine;
        return;
      }
      if (law_.obstacles && has_relief_ && bedrock_[index(u, v)] - surface_[from] > law_.bare.straight) {
        report_.travel += rows / frame_.cosine;
        return deposit(place);
      }
      place = {u, v};
      ++rows;
    }
    const std::size_t here = index(place.u, place.v);
    if (rows >= flight_limit || draws.unit() < stay_chance(here) || in_shadow(place, draws)) {
      report_.travel += rows / frame_.cosine;
      return deposit(place);
    }
    hop = hop_rows(surface_[here], draws);
  }
}

/// Open boundary: slabs come in over the upwind edges, as if the same ground went on beyond them.
void SlabReference::let_inflow_enter() {
  if (!open_ || law_.inflow <= 0) return;
  std::uint64_t number = 0;
  const auto enter_over = [&](int u, int v, double rate) {
    Draws draws{random_word(key_, 0, number++, of_inflow)};
    for (int left = static_cast<int>(std::floor(rate + draws.unit())); left > 0; --left) enter(draws, {u, v});
  };
  for (int u = 0; u < frame_.width; ++u) enter_over(u, 0, law_.inflow);
  if (frame_.tangent > 0) {
    for (int v = 0; v < frame_.length; ++v) enter_over(0, v, law_.inflow * frame_.tangent);
  }
}

void SlabReference::enter(Draws& draws, Place entry) {
  ++report_.slabs_in;
  // Where in its hop the slab crosses the edge is random: it comes down up to one hop further on.
  const std::size_t cell = index(entry.u, entry.v);
  const double sideways = draws.unit();
  const double share = draws.unit();
  const int rows = static_cast<int>(share * hop_rows(surface_[cell], draws));
  Place place = entry;
  for (int row = 1; row <= rows; ++row) {
    int u = entry.u + static_cast<int>(std::floor(row * frame_.tangent + sideways));
    int v = place.v + 1;
    if (!inside(u, v)) {
      ++report_.slabs_out;
      return;
    }
    if (law_.obstacles && bedrock_[index(u, v)] - surface_[index(place.u, place.v)] > law_.bare.straight) break;
    place = {u, v};
  }
  const std::size_t here = index(place.u, place.v);
  if (draws.unit() < stay_chance(here) || in_shadow(place, draws)) {
    deposit(place);
  } else {
    fly(place, hop_rows(surface_[here], draws), draws);
  }
}

/// Algorithm 5: the slab slides down the steepest slope until it can stay.
void SlabReference::deposit(Place place) {
  std::size_t cell = index(place.u, place.v);
  for (std::size_t next = steepest_neighbour(place, false); next != nowhere; next = steepest_neighbour(place, false)) {
    cell = next;
    place = place_of(next);
  }
  change(cell, +1);
}

/// Algorithm 6, with true distances at any bearing but for the nearest two cells (ShadowFalls).
bool SlabReference::in_shadow(Place place, Draws& draws) const {
  const double sideways = frame_.tangent > 0 ? draws.unit() : 0;
  const std::int64_t here = static_cast<std::int64_t>(surface_[index(place.u, place.v)]) << fixed_point_bits;
  const std::int64_t top = static_cast<std::int64_t>(highest_) << fixed_point_bits;
  const auto columns = [&](int row) { return static_cast<int>(std::floor(row * frame_.tangent + sideways)); };
  int u = place.u;
  int v = place.v;
  const int rows_around = kernels::rows_around(frame_.length, frame_.tangent);
  for (int row = 1; row <= rows_around; ++row) {
    const std::int64_t line = here + (row == 1 ? next_fall_ : row == 2 ? second_fall_ : row_fall_ * row);
    if (row > 1 && line >= top) return false;
    --v;
    if (v < 0) {
      if (open_) return false;
      v += frame_.length;
    }
    if (frame_.tangent > 0) {
      u = place.u - columns(row);
      if (open_ && u < 0) return false;
      u = wrap(u, frame_.width);
    }
    if ((static_cast<std::int64_t>(surface_[index(u, v)]) << fixed_point_bits) > line) return true;
  }
  return false;
}

/// Folds a place over the torus; false where it lies beyond an open edge.
bool SlabReference::inside(int& u, int& v) const {
  if (open_ && (u < 0 || u >= frame_.width || v < 0 || v >= frame_.length)) return false;
  if (u < 0 || u >= frame_.width) u = wrap(u, frame_.width);
  if (v < 0 || v >= frame_.length) v = wrap(v, frame_.length);
  return true;
}

double SlabReference::stay_chance(std::size_t cell) const {
  const double chance = surface_[cell] > ground(cell) ? law_.p_sand : law_.p_bare;
  if (cover_.empty()) return chance;
  return chance + cover_[cell] / 255.0 * (1 - chance);
}

/// Length of a hop that starts on ground of this height, in rows of the frame, rounded at random. 0: a slab that was to
/// lift lies where it lay; one in the air comes down a row further on all the same.
int SlabReference::hop_rows(std::int32_t height, Draws& draws) const {
  double cells = strength_;
  if (law_.hop.depends_on_height()) {
    const double reference = mean_ - law_.hop.deviation_weight * deviation_ / static_cast<double>(surface_.size());
    cells = law_.hop.cells(strength_, height - reference);
  }
  const double rows = std::min(cells * frame_.cosine, most_hop_rows(strength_, frame_.cosine, frame_.length));
  const double whole = std::floor(rows);
  return static_cast<int>(rows == whole ? whole : std::floor(rows + draws.unit()));
}

void SlabReference::change(std::size_t cell, int slabs) {
  const std::int32_t before = surface_[cell];
  const std::int32_t after = before + slabs;
  surface_[cell] = static_cast<std::uint16_t>(after);
  if (static_cast<std::size_t>(after) >= height_count_.size()) {
    height_count_.resize(static_cast<std::size_t>(after) + 1);
  }
  --height_count_[static_cast<std::size_t>(before)];
  ++height_count_[static_cast<std::size_t>(after)];
  highest_ = std::max(highest_, after);
  while (highest_ > 0 && height_count_[static_cast<std::size_t>(highest_)] == 0) --highest_;
  if (law_.hop.deviation_weight != 0) deviation_ += std::abs(after - mean_) - std::abs(before - mean_);
}

}  // namespace erg::models
