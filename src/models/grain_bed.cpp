#include "models/grain_bed.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace erg {
namespace {

constexpr float no_shadow = -1e30f;
constexpr float speed_parts = 64;  // of a m/s, in the sums of impact speeds

/// The four ways to a neighbour: across the wind, along it, and the two diagonals.
struct Way {
  int du;
  int dv;
};
constexpr Way ways[4] = {{1, 0}, {0, 1}, {1, 1}, {-1, 1}};

// How many columns a line along the wind has moved sideways when it meets row `v`.
int sideways_at(const WindFrame& frame, int v) { return static_cast<int>(std::floor(v * frame.tangent + 0.5)); }

/// The wake of plants along the wind.
class Wake {
 public:
  Wake(const ParameterValues& values, const WindFrame& frame, double cell_size)
      : shelter_(values.real("plant_shelter")),
        length_(values.real("wake_length") * values.real("plant_height") / cell_size),
        spread_(values.real("wake_spread")),
        along_u_(frame.tangent * frame.cosine),
        along_v_(frame.cosine) {}

  /// Cells to either side that a wake may touch.
  int reach() const { return static_cast<int>(std::ceil(length_ * (1 + spread_))) + 1; }

  /// The share of the wind left at (du, dv) cells from a cell with this cover.
  double wind_left(double cover, int du, int dv) const {
    if (du == 0 && dv == 0) return 1 - shelter_ * cover;
    const double behind = du * along_u_ + dv * along_v_;
    const double aside = std::abs(du * along_v_ - dv * along_u_);
    if (behind <= 0 || behind >= length_) return 1;
    const double edge = 0.5 + spread_ * behind;
    if (aside >= edge + 0.5) return 1;
    const double inside = std::min(1.0, edge + 0.5 - aside);  // fades over the last cell
    return 1 - shelter_ * cover * inside * (1 - behind / length_);
  }

 private:
  double shelter_;
  double length_;  // cells
  double spread_;
  double along_u_;
  double along_v_;
};

}  // namespace

std::vector<float> plant_shelter(const ParameterValues& values, const Terrain& terrain, const Grid<float>& plants,
                                 const WindFrame& frame) {
  std::vector<float> shelter(terrain.extent().cells(), 1.0f);
  const Wake wake(values, frame, terrain.cell_size());
  const bool torus = terrain.boundary() == Boundary::torus;
  const int reach_u = std::min(wake.reach(), frame.width);
  const int reach_v = std::min(wake.reach(), frame.length);
  for (int v = 0; v < frame.length; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      const double cover = std::min(1.0f, plants[frame.cell(u, v)]);
      if (cover <= 0) continue;
      for (int dv = 0; dv <= reach_v; ++dv) {
        for (int du = -reach_u; du <= reach_u; ++du) {
          const double left = wake.wind_left(cover, du, dv);
          const bool inside = u + du >= 0 && u + du < frame.width && v + dv < frame.length;
          if (left >= 1 || (!torus && !inside)) continue;
          float& share =
              shelter[static_cast<std::size_t>(wrap(v + dv, frame.length)) * frame.width + wrap(u + du, frame.width)];
          share = std::min(share, static_cast<float>(left));
        }
      }
    }
  }
  return shelter;
}

void GrainBed::load(const Terrain& terrain, const WindFrame& frame, double fall, const std::vector<float>& shelter) {
  frame_ = frame;
  torus_ = terrain.boundary() == Boundary::torus;
  quantum_ = terrain.quantum();
  fall_ = fall;
  shelter_ = shelter;
  const std::size_t cells = terrain.extent().cells();
  for (Counts* counts : {&bedrock_, &mobile_, &bonded_, &gone_, &come_, &stirred_, &asked_, &asked_speed_}) {
    counts->assign(cells, 0);
  }
  const Field* bonded = find_field(terrain.fields(), bonded_field);
  lowest_ = std::numeric_limits<std::int32_t>::max();
  for (int v = 0; v < frame.length; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      const std::size_t from = frame.cell(u, v);
      const std::size_t to = at(u, v);
      bedrock_[to] = terrain.bedrock()[from];
      mobile_[to] = terrain.mobile()[from];
      // An edit may have taken bonded grains away.
      if (bonded != nullptr) bonded_[to] = std::min(mobile_[to], static_cast<std::int32_t>(bonded->values[from]));
      lowest_ = std::min(lowest_, bedrock_[to]);
    }
  }
  points_.assign(static_cast<std::size_t>(frame.width + 2) * (frame.length + 2), GroundPoint{});
}

void GrainBed::store(Terrain& terrain) const {
  Grid<std::int32_t>& mobile = terrain.edit_mobile();
  Field* bonded = find_field(terrain.edit_fields(), bonded_field);
  for (int v = 0; v < frame_.length; ++v) {
    for (int u = 0; u < frame_.width; ++u) {
      const std::size_t to = frame_.cell(u, v);
      mobile[to] = mobile_[at(u, v)];
      if (bonded != nullptr) bonded->values[to] = static_cast<float>(bonded_[at(u, v)]);
    }
  }
}

FrozenGround GrainBed::ground() const { return {points_.data(), frame_.width, frame_.length, torus_}; }

void GrainBed::add(Counts& counts, int u, int v, std::int32_t amount) {
  std::atomic_ref(counts[at(u, v)]).fetch_add(amount, std::memory_order_relaxed);
}

void GrainBed::ask(int u, int v, int grains, float speed) {
  if (grains == 0) return;
  add(asked_, u, v, grains);
  add(asked_speed_, u, v, static_cast<std::int32_t>(speed * speed_parts) * grains);
}

void GrainBed::freeze(Executor& executor) {
  executor.for_pieces(frame_.length, [this](std::int64_t first, std::int64_t last) { freeze_heights(first, last); });
  const int start = torus_ ? -shadow_warm_up() : 0;
  executor.for_pieces(frame_.width,
                      [this, start](std::int64_t first, std::int64_t last) { freeze_shadow(first, last, start); });
  freeze_rim();
}

void GrainBed::freeze_heights(std::int64_t first_row, std::int64_t last_row) {
  for (int v = static_cast<int>(first_row); v < last_row; ++v) {
    for (int u = 0; u < frame_.width; ++u) {
      const std::size_t cell = at(u, v);
      const std::int64_t count = static_cast<std::int64_t>(bedrock_[cell]) + mobile_[cell] - lowest_;
      point(u, v) = {static_cast<float>(static_cast<double>(count) * quantum_), no_shadow, shelter_[cell],
                     mobile_[cell] - bonded_[cell]};
    }
  }
}

// Rows before the grid from which a shadow can still reach into it.
int GrainBed::shadow_warm_up() const {
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();
  for (std::size_t cell = 0; cell < mobile_.size(); ++cell) {
    low = std::min(low, bedrock_[cell] + mobile_[cell]);
    high = std::max(high, bedrock_[cell] + mobile_[cell]);
  }
  const int limit = frame_.tangent > 0 ? largest_side : frame_.length;
  const double reach = (static_cast<double>(high) - low) * frame_.cosine / std::max(fall_, 1e-12) + 3;
  return reach < limit ? static_cast<int>(reach) : limit;
}

// As shadow_map in wind/shadow.h, but keeps the height of the shadow line over every cell. Each line meets a cell once,
// so lines may be walked side by side.
void GrainBed::freeze_shadow(std::int64_t first_line, std::int64_t last_line, int start) {
  const auto fall_near = static_cast<float>(fall_ * quantum_);
  const auto fall_far = static_cast<float>(fall_ * quantum_ / frame_.cosine);
  for (int line = static_cast<int>(first_line); line < last_line; ++line) {
    float far = no_shadow;
    float near = no_shadow;
    for (int row = start; row < frame_.length; ++row) {
      const int sideways = sideways_at(frame_, row);
      const int column = wrap(line + sideways, frame_.width);
      if (!torus_ && row > start && column == 0 && sideways != sideways_at(frame_, row - 1)) far = near = no_shadow;
      GroundPoint& here = point(column, wrap(row, frame_.length));
      if (row >= 0) here.shadow = std::max(far, near);
      far = std::max(here.height, far) - fall_far;
      near = here.height - fall_near;
    }
  }
}

void GrainBed::freeze_rim() {
  const auto inside = [this](int place, int count) {
    return torus_ ? wrap(place, count) : std::clamp(place, 0, count - 1);
  };
  for (int v = -1; v <= frame_.length; ++v) {
    for (const int u : {-1, frame_.width}) point(u, v) = point(inside(u, frame_.width), inside(v, frame_.length));
  }
  for (int u = 0; u < frame_.width; ++u) {
    for (const int v : {-1, frame_.length}) point(u, v) = point(u, inside(v, frame_.length));
  }
}

int GrainBed::freed(std::size_t cell, int missing, double abrasion, StepKey key, std::uint64_t sweep) {
  const double wanted = missing * abrasion;
  const int whole = static_cast<int>(wanted + random_unit(key, sweep, cell, 0));
  return std::min(whole, bonded_[cell]);
}

void GrainBed::settle_accounts(Executor& executor) {
  executor.for_pieces(static_cast<std::int64_t>(cells()), [this](std::int64_t first, std::int64_t last) {
    for (auto cell = static_cast<std::size_t>(first); cell < static_cast<std::size_t>(last); ++cell) {
      mobile_[cell] += come_[cell] - gone_[cell];
      stirred_[cell] += come_[cell] + gone_[cell];
      come_[cell] = gone_[cell] = 0;
    }
  });
}

// Calls rule(higher or equal cell, lower cell, difference of height, cell that keys draws) for every edge of one
// direction, in classes of edges that share no cell, so that all edges of a class can be worked on at once. True when
// any call returned true.
template <typename Rule>
bool GrainBed::along_edges(Executor& executor, int direction, const Rule& rule) {
  const Way way = ways[direction];
  const bool across = way.dv == 0;
  const int extent = across ? frame_.width : frame_.length;  // along which classes alternate
  if ((way.du != 0 && frame_.width < 2) || (way.dv != 0 && frame_.length < 2)) return false;
  std::atomic<bool> moved{false};
  const auto edge = [&](int u, int v) {
    const int to_u = u + way.du;
    const int to_v = v + way.dv;
    const bool over = to_u < 0 || to_u >= frame_.width || to_v >= frame_.length;
    if (over && !torus_) return false;
    const std::size_t here = at(u, v);
    const std::size_t there = at(wrap(to_u, frame_.width), wrap(to_v, frame_.length));
    const std::int32_t difference = bedrock_[here] + mobile_[here] - bedrock_[there] - mobile_[there];
    return difference >= 0 ? rule(here, there, difference, here) : rule(there, here, -difference, here);
  };
  // Even places, odd places, and the edge that closes a torus of odd extent.
  const int paired = extent - extent % 2;
  for (int part = 0; part < 2 + extent % 2; ++part) {
    const int first = part == 2 ? paired : part;
    const int count = part == 2 ? 1 : paired / 2;
    if (across) {
      executor.for_pieces(frame_.length, [&](std::int64_t begin, std::int64_t end) {
        bool any = false;
        for (int v = static_cast<int>(begin); v < end; ++v) {
          for (int k = 0; k < count; ++k) any |= edge(first + 2 * k, v);
        }
        if (any) moved.store(true, std::memory_order_relaxed);
      });
    } else {
      executor.for_pieces(count, [&](std::int64_t begin, std::int64_t end) {
        bool any = false;
        for (int k = static_cast<int>(begin); k < end; ++k) {
          for (int u = 0; u < frame_.width; ++u) any |= edge(u, first + 2 * k);
        }
        if (any) moved.store(true, std::memory_order_relaxed);
      });
    }
  }
  return moved;
}

void GrainBed::slide(Executor& executor, StandingSteps steps, int passes, StepKey key, std::uint64_t sweep) {
  for (int pass = 0; pass < passes; ++pass) {
    // Four directions in an order drawn anew, so that none comes first always.
    int order[4] = {0, 1, 2, 3};
    for (std::uint32_t last = 3; last > 0; --last) {
      std::swap(order[last], order[random_below(key, sweep, static_cast<std::uint64_t>(pass), last, last + 1)]);
    }
    bool moved = false;
    for (const int direction : order) {
      const std::int32_t standing = direction < 2 ? steps.straight : steps.diagonal;
      moved |= along_edges(executor, direction,
                           [this, standing](std::size_t high, std::size_t low, std::int32_t difference, std::size_t) {
                             if (difference <= standing) return false;
                             const std::int32_t wanted = (difference - standing + 1) / 2;
                             const std::int32_t going = std::min(wanted, mobile_[high] - bonded_[high]);
                             mobile_[high] -= going;
                             mobile_[low] += going;
                             return going > 0;
                           });
    }
    if (!moved) return;
  }
}

void GrainBed::creep(Executor& executor, double chance, StepKey key, std::uint64_t sweep) {
  for (int direction = 0; direction < 2; ++direction) {
    along_edges(executor, direction,
                [&, this](std::size_t high, std::size_t low, std::int32_t difference, std::size_t cell) {
                  const double likely = std::min(0.5, chance * difference);
                  if (difference < 1 || mobile_[high] <= bonded_[high]) return false;
                  if (random_unit(key, sweep, cell, static_cast<std::uint64_t>(direction)) >= likely) return false;
                  --mobile_[high];
                  ++mobile_[low];
                  return true;
                });
  }
}

void GrainBed::bond(Executor& executor, double share, StepKey key, std::uint64_t sweep) {
  executor.for_pieces(static_cast<std::int64_t>(cells()), [&, this](std::int64_t first, std::int64_t last) {
    for (auto cell = static_cast<std::size_t>(first); cell < static_cast<std::size_t>(last); ++cell) {
      const std::int32_t resting = mobile_[cell] - bonded_[cell] - stirred_[cell];
      if (resting > 0 && random_unit(key, sweep, cell, 0) < share) bonded_[cell] += resting;
    }
  });
}

}  // namespace erg
