#include "transport/snow_machine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "transport/box_mean.h"
#include "transport/fixed_point.h"
#include "transport/sub_sweep.h"

namespace erg {
namespace {

/// What the random words of a step are for; each has a key space of its own.
enum SnowWord : std::uint64_t { flights = 60, polls, lines, drift, fall, bonds, slides, shuffles };

constexpr int slide_rounds = 2;

/// Adds to a whole number that other threads add to.
void add(std::int32_t& value, std::int32_t change) {
  std::atomic_ref<std::int32_t>(value).fetch_add(change, std::memory_order_relaxed);
}

std::uint64_t cell_word(std::uint64_t word, std::uint64_t number) {
  return mix64(word + 0x9e3779b97f4a7c15u * (number + 1));
}

}  // namespace

StepReport SnowMachine::step(Terrain& terrain, SnowLayers& layers, const SnowLaw& law, Radii radii, double shadow_fall,
                             const WindNow& wind, StepKey key, Executor& executor) {
  law_ = &law;
  executor_ = &executor;
  layers_ = &layers;
  extent_ = terrain.extent();
  boundary_ = terrain.boundary();
  inflow_ = boundary_ == Boundary::open ? terrain.inflow() : 0;
  radii_ = radii;
  frame_ = wind_frame(extent_, wind.bearing);
  key_ = key;
  tangent_24_ = static_cast<std::int64_t>(frame_.tangent * 0x1p24);
  report_ = {};
  bedrock_ = terrain.bedrock().cells().data();
  mobile_ = terrain.edit_mobile().cells().data();
  measure_weather(shadow_fall);
  if (executor.sub_sweeps() == 0) {
    fly_one_by_one();
  } else {
    fly_in_sweeps(executor.sub_sweeps());
  }
  report_.polls = static_cast<std::int64_t>(extent_.cells());
  report_.travel /= frame_.cosine;
  slide();
  let_snow_fall();
  rest();
  terrain.ledger().in += report_.slabs_in;
  terrain.ledger().out += report_.slabs_out;
  return report_;
}

/// Calls visit(u, v) for all u below `width` and v below `length` on all threads, neighbours in memory one after
/// another.
template <typename Visit>
void SnowMachine::for_frame(int width, int length, const Visit& visit) const {
  const bool lines_in_memory = frame_.step_v == 1 || frame_.step_v == -1;
  executor_->for_pieces(lines_in_memory ? width : length, [&](std::int64_t begin, std::int64_t end) {
    for (int outer = static_cast<int>(begin); outer < end; ++outer) {
      for (int inner = 0; inner < (lines_in_memory ? length : width); ++inner) {
        visit(lines_in_memory ? outer : inner, lines_in_memory ? inner : outer);
      }
    }
  });
}

// --- weather ---

void SnowMachine::measure_weather(double shadow_fall) {
  const std::size_t cells = extent_.cells();
  height_.resize(cells);
  relative_.resize(cells);
  speed_.resize(cells);
  dark_.resize(cells);
  chance_.resize(cells);
  std::atomic<std::int32_t> low{std::numeric_limits<std::int32_t>::max()};
  std::atomic<std::int32_t> high{std::numeric_limits<std::int32_t>::min()};
  executor_->for_pieces(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    std::int32_t most = std::numeric_limits<std::int32_t>::min();
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const std::int32_t here = surface(k);
      height_[k] = here;
      least = std::min(least, here);
      most = std::max(most, here);
    }
    for (std::int32_t seen = low; least < seen && !low.compare_exchange_weak(seen, least);) {
    }
    for (std::int32_t seen = high; most > seen && !high.compare_exchange_weak(seen, most);) {
    }
  });
  box_sum(extent_, boundary_, radii_.around, height_, scratch_, around_, *executor_);
  box_sum(extent_, boundary_, radii_.smooth, height_, scratch_, smooth_, *executor_);
  box_sum(extent_, boundary_, radii_.smooth, smooth_, scratch_, height_, *executor_);
  std::swap(smooth_, height_);
  // Rows before the first one from which a shadow can still reach over the torus edge.
  const double reach = (static_cast<double>(high) - low) * frame_.cosine / std::max(shadow_fall, 1e-6) + 3;
  const int limit = 2 * frame_.length;
  const int start = boundary_ == Boundary::open ? 0 : -(reach < limit ? static_cast<int>(reach) : limit);
  executor_->for_pieces(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    for (int line = static_cast<int>(begin); line < end; ++line) measure_line(line, shadow_fall, start);
  });
}

/// Follows a line down the wind: shadow, wind and chance of each cell that it meets. Lines share no cell.
void SnowMachine::measure_line(int line, double shadow_fall, int start_row) {
  const SnowLaw& law = *law_;
  const std::int64_t fall_far = fixed_point(shadow_fall / frame_.cosine);
  const std::int64_t fall_near = fixed_point(shadow_fall);
  const double square = (2.0 * radii_.smooth + 1) * (2.0 * radii_.smooth + 1);
  const auto smooth_share = static_cast<float>(1 / (square * square));
  const auto around_share = static_cast<float>(1 / ((2.0 * radii_.around + 1) * (2.0 * radii_.around + 1)));
  const auto quantum = law.slope_scale;  // slopes; heights in m follow from the cells of speed_by_height
  const auto along = static_cast<float>(frame_.cosine);
  const auto across = static_cast<float>(frame_.tangent * frame_.cosine);
  std::int64_t far = std::numeric_limits<std::int64_t>::min() / 4;
  std::int64_t near = far;
  int last_u = -1;
  for (int row = start_row; row < frame_.length; ++row) {
    const auto sideways = static_cast<int>((row * tangent_24_ + (std::int64_t{1} << 23)) >> 24);
    const int u = wrap(line + sideways, frame_.width);
    const int v = wrap(row, frame_.length);
    if (boundary_ == Boundary::open && u < last_u) far = near = std::numeric_limits<std::int64_t>::min() / 4;
    last_u = u;
    const std::size_t here = cell(u, v);
    const std::int64_t height = static_cast<std::int64_t>(surface(here)) << fixed_point_bits;
    if (row >= 0) {
      int before_v = v - 1, after_v = v + 1, left_u = u - 1, right_u = u + 1;
      int same_u = u, same_v = v;
      if (!inside(same_u, before_v)) before_v = v;
      if (!inside(same_u, after_v)) after_v = v;
      if (!inside(left_u, same_v)) left_u = u;
      if (!inside(right_u, same_v)) right_u = u;
      const auto rise = static_cast<float>(smooth_[cell(u, after_v)] - smooth_[cell(u, before_v)]) * along +
                        static_cast<float>(smooth_[cell(right_u, v)] - smooth_[cell(left_u, v)]) * across;
      const float level = static_cast<float>(smooth_[here]) * smooth_share;
      const float over = level - static_cast<float>(around_[here]) * around_share;
      dark_[here] = height < std::max(far, near) ? 1 : 0;
      relative_[here] = static_cast<float>(surface(here)) - level;
      speed_[here] = local_wind(law, over, 0.5f * rise * smooth_share * quantum);
      chance_[here] = dark_[here] ? 0 : lift_chance(law, speed_[here], law.now - layers_->landed[here]);
    }
    far = std::max(height, far) - fall_far;
    near = height - fall_near;
  }
}

/// Folds a place over the torus; false where it lies beyond an open edge.
bool SnowMachine::inside(int& u, int& v) const {
  const bool within = u >= 0 && u < frame_.width && v >= 0 && v < frame_.length;
  if (within) return true;
  if (boundary_ == Boundary::open) return false;
  u = wrap(u, frame_.width);
  v = wrap(v, frame_.length);
  return true;
}

// --- flights ---

template <typename Sink>
void SnowMachine::poll(Place place, std::uint64_t word, Sink& sink) const {
  const std::size_t here = cell(place.u, place.v);
  const bool hard = layers_->loose[here] <= 0;
  if (hard && (mobile_[here] <= 0 || dark_[here])) return;
  if ((word & 0xffff) >= (hard ? entrainment_chance(*law_, speed_[here], layers_->age[here]) : chance_[here])) return;
  if (hard) sink.change(here, Change::free);
  ++sink.report.lifts;
  // Each cell is polled once a step, by one thread.
  if (Grid<std::int32_t>* const counts = executor_->lift_counts()) ++(*counts)[here];
  sink.change(here, Change::lift);
  fly(place, word, sink, false);
}

/// A slab in the air, from hop to hop. One that enters over an edge begins somewhere in its first hop.
template <typename Sink>
void SnowMachine::fly(Place place, std::uint64_t word, Sink& sink, bool enters) const {
  const SnowLaw& law = *law_;
  const auto sideways = static_cast<std::int64_t>(word >> 40);
  const int first_u = place.u;
  const int limit = longest_flight * frame_.length;
  const auto cosine = static_cast<float>(frame_.cosine);
  int flown = 0;
  while (true) {
    word = mix64(word);
    const std::size_t start = cell(place.u, place.v);
    const float start_height = relative_[start] + law.clearance;
    // Hops of one wind differ: half to one and a half times the mean.
    const float spread = 0.5f + unit_24(static_cast<std::uint32_t>(word >> 24));
    float rows_exact = hop_cells(law, speed_[start]) * cosine * spread;
    if (enters) rows_exact *= unit_24(static_cast<std::uint32_t>(word >> 8));
    enters = false;
    const int rows = std::max(1, static_cast<int>(rows_exact + unit_24(static_cast<std::uint32_t>(word))));
    std::size_t from = start;
    std::size_t here = start;
    int row = 0;
    while (row < rows) {
      int u = first_u + static_cast<int>(((flown + row + 1) * tangent_24_ + sideways) >> 24);
      int v = place.v + 1;
      if (!inside(u, v)) {
        sink.report.travel += flown + row;
        ++sink.report.slabs_out;
        return;
      }
      if (bedrock_[cell(u, v)] - surface(here) > law.wall) {
        sink.report.travel += flown + row;
        return sink.change(here, Change::land);
      }
      from = here;
      place = {u, v};
      here = cell(u, v);
      ++row;
      if (relative_[here] > start_height) break;
    }
    flown += row;
    const bool hard = layers_->loose[here] <= 0;
    const auto random = static_cast<std::uint32_t>(word >> 32);
    if (hard && mobile_[here] > 0) {
      strike(here, from, static_cast<float>(row) / static_cast<float>(rows), random * 0x9e3779b1u >> 8, sink);
    }
    const float rest =
        dark_[here] ? 1 : (!hard ? law.rest_loose : (mobile_[here] > 0 ? law.rest_hard : law.rest_ground));
    const std::uint64_t draws = mix64(word ^ 0x5851f42d4c957f2du);
    if (unit_24(static_cast<std::uint32_t>(draws)) < rest || flown >= limit) {
      sink.report.travel += flown;
      return sink.change(here, Change::land);
    }
    if (law.suspension > 0 && unit_24(static_cast<std::uint32_t>(draws >> 32)) < law.suspension) {
      sink.report.travel += flown;
      ++sink.report.slabs_out;
      return;
    }
  }
}

/// An impact on bonded snow may free a slab of it in place.
template <typename Sink>
void SnowMachine::strike(std::size_t here, std::size_t from, float flown, std::uint32_t random, Sink& sink) const {
  const SnowLaw& law = *law_;
  const auto rise = static_cast<float>(surface(here) - surface(from));
  const float easy = abrasion_chance(law, speed_[here], rise, flown, layers_->age[here], 1.0f);
  // No snow is weaker than the table's lowest strength: most impacts need no look at the noise.
  if (unit_24(random) * law.strength_table[0] * law.strength_table[0] >= easy) return;
  const int x = static_cast<int>(here % static_cast<std::size_t>(extent_.nx));
  const int y = static_cast<int>(here / static_cast<std::size_t>(extent_.nx));
  if (unit_24(random) * snow_strength(law, x, y, mobile_[here]) < easy) sink.change(here, Change::free);
}

/// Open boundary: drift comes in over the upwind edges.
template <typename Sink>
void SnowMachine::let_drift_enter(Sink& sink) const {
  if (inflow_ <= 0) return;
  const std::uint64_t base = random_word(key_, 0, 0, drift);
  std::uint64_t count = 0;
  const auto enter = [&](int u, int v, double rate) {
    std::uint64_t word = cell_word(base, count++);
    const int slabs = static_cast<int>(rate + static_cast<double>(word >> 11) * 0x1.0p-53);
    for (int slab = 0; slab < slabs; ++slab) {
      word = mix64(word);
      ++sink.report.slabs_in;
      fly({u, v}, word, sink, true);
    }
  };
  for (int u = 0; u < frame_.width; ++u) enter(u, 0, inflow_);
  if (frame_.tangent > 0) {
    for (int v = 0; v < frame_.length; ++v) enter(0, v, inflow_ * frame_.tangent);
  }
}

/// The reference: each slab sees what the last one left.
void SnowMachine::fly_one_by_one() {
  struct Direct {
    SnowMachine& machine;
    StepReport& report;
    void change(std::size_t cell, Change change) {
      if (change != Change::free) machine.mobile_[cell] += change == Change::land ? 1 : -1;
      machine.layers_->loose[cell] += change == Change::lift ? -1 : 1;
      if (change == Change::land) machine.layers_->landed[cell] = machine.law_->now;
    }
  } direct{*this, report_};
  let_drift_enter(direct);
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
    poll({u, v}, cell_word(base, number), direct);
  }
}

void SnowMachine::fly_in_sweeps(int sweeps) {
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    std::uint8_t rows[256];
    permute_rows(key_, 0, lines, sweep, sweeps, rows);
    batches_.clear();
    if (sweep == 0) poll_lines(0, 0, -1, sweeps, rows);
    executor_->for_pieces(frame_.width,
                          [&](std::int64_t begin, std::int64_t end) { poll_lines(begin, end, sweep, sweeps, rows); });
    write_events();
  }
}

/// Decides the flights of the cells that a sub-sweep polls on some lines; sub-sweep -1 is the drift that enters.
void SnowMachine::poll_lines(std::int64_t begin, std::int64_t end, int sweep, int sweeps, const std::uint8_t* rows) {
  struct Collected : Batch {
    void change(std::size_t cell, Change change) { events.push_back({static_cast<std::uint32_t>(cell), change}); }
  } collected;
  if (sweep < 0) let_drift_enter(collected);
  const std::uint64_t base = random_word(key_, 0, 0, flights);
  const std::uint64_t poll_base = random_word(key_, 0, 0, polls);
  const float least_wind = law_->threshold + law_->age_threshold.at(law_->step_hours);  // of the freshest loose snow
  for (int u = static_cast<int>(begin); u < end; ++u) {
    const std::uint64_t line_word = cell_word(poll_base, static_cast<std::uint64_t>(u));
    for (int block = 0; block < frame_.length; block += sweeps) {
      const std::uint32_t byte =
          mix32(static_cast<std::uint32_t>(line_word) + static_cast<std::uint32_t>(block)) & 0xff;
      const int v = block + rows[byte];
      if (v >= frame_.length) continue;
      const std::size_t here = cell(u, v);
      if (dark_[here] || speed_[here] < least_wind) continue;
      poll({u, v}, cell_word(base, number(u, v)), collected);
    }
  }
  const std::lock_guard lock(mutex_);
  batches_.push_back(std::move(collected));
}

void SnowMachine::write_events() {
  for (const Batch& batch : batches_) report_ += batch.report;
  executor_->for_pieces(static_cast<std::int64_t>(batches_.size()), [&](std::int64_t begin, std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      for (const Event& event : batches_[k].events) {
        if (event.change != Change::free) add(mobile_[event.cell], event.change == Change::land ? 1 : -1);
        add(layers_->loose[event.cell], event.change == Change::lift ? -1 : 1);
        if (event.change == Change::land) {
          std::atomic_ref<float>(layers_->landed[event.cell]).store(law_->now, std::memory_order_relaxed);
        }
      }
    }
  });
  // Several impacts may have freed the same slab.
  executor_->for_pieces(static_cast<std::int64_t>(batches_.size()), [&](std::int64_t begin, std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      for (const Event& event : batches_[k].events) {
        if (event.change != Change::free) continue;
        std::atomic_ref<std::int32_t> loose(layers_->loose[event.cell]);
        if (loose.load(std::memory_order_relaxed) > mobile_[event.cell]) loose.store(mobile_[event.cell]);
      }
    }
  });
}

// --- slides ---

void SnowMachine::slide() {
  for (std::uint64_t round = 0; round < slide_rounds; ++round) {
    std::uint32_t order[4] = {0, 1, 2, 3};
    for (std::uint32_t last = 3; last > 0; --last) {
      std::swap(order[last], order[random_below(key_, round, last, slides, last + 1)]);
    }
    for (const std::uint32_t kind : order) slide_class(kind < 2, static_cast<int>(kind & 1));
  }
}

/// The edges along (or across) the wind that begin at even (odd) places; those over the border come by themselves.
void SnowMachine::slide_class(bool along, int odd) {
  const int count = along ? frame_.length : frame_.width;
  const int edges = (count - odd) / 2;
  for_frame(along ? frame_.width : edges, along ? edges : frame_.length, [&](int u, int v) {
    if (along) {
      slide_edge(cell(u, 2 * v + odd), cell(u, 2 * v + odd + 1));
    } else {
      slide_edge(cell(2 * u + odd, v), cell(2 * u + odd + 1, v));
    }
  });
  if (odd == 0 || boundary_ == Boundary::open || count < 3) return;
  for_frame(along ? frame_.width : 1, along ? 1 : frame_.length, [&](int u, int v) {
    slide_edge(along ? cell(u, count - 1) : cell(count - 1, v), along ? cell(u, 0) : cell(0, v));
  });
}

void SnowMachine::slide_edge(std::size_t a, std::size_t b) {
  const std::int32_t difference = surface(a) - surface(b);
  if (difference <= law_->standing && -difference <= law_->standing) return;
  const std::size_t from = difference > 0 ? a : b;
  const std::size_t to = difference > 0 ? b : a;
  if (layers_->loose[from] <= 0) return;
  --mobile_[from];
  --layers_->loose[from];
  ++mobile_[to];
  ++layers_->loose[to];
  layers_->landed[to] = law_->now;
}

// --- rest ---

/// Snow falls at random and comes to lie on the lowest of nine cells.
void SnowMachine::let_snow_fall() {
  if (law_->snowfall <= 0) return;
  const std::uint64_t base = random_word(key_, 0, 0, fall);
  batches_.clear();
  executor_->for_pieces(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    Batch batch;
    for (int u = static_cast<int>(begin); u < end; ++u) {
      for (int v = 0; v < frame_.length; ++v) {
        const std::uint64_t word = cell_word(base, number(u, v));
        const int slabs = static_cast<int>(law_->snowfall + unit_24(static_cast<std::uint32_t>(word)));
        if (slabs == 0) continue;
        std::size_t lowest = cell(u, v);
        for (int k = 0; k < 9; ++k) {
          const int turned = (k + static_cast<int>(word >> 32 & 0xff)) % 9;
          int near_u = u + turned / 3 - 1;
          int near_v = v + turned % 3 - 1;
          if (inside(near_u, near_v) && surface(cell(near_u, near_v)) < surface(lowest)) lowest = cell(near_u, near_v);
        }
        for (int slab = 0; slab < slabs; ++slab) {
          batch.events.push_back({static_cast<std::uint32_t>(lowest), Change::land});
        }
      }
    }
    batch.report.slabs_in = static_cast<std::int64_t>(batch.events.size());
    const std::lock_guard lock(mutex_);
    batches_.push_back(std::move(batch));
  });
  write_events();
}

/// Loose snow bonds from below; bonded snow grows older.
void SnowMachine::rest() {
  const std::uint64_t base = random_word(key_, 0, 0, bonds);
  for_frame(frame_.width, frame_.length, [&](int u, int v) {
    const std::size_t here = cell(u, v);
    std::int32_t& loose = layers_->loose[here];
    float& age = layers_->age[here];
    if (loose == mobile_[here]) age = 0;  // nothing bonded is left
    const float bonded = static_cast<float>(mobile_[here] - loose);
    if (bonded > 0) age += law_->step_hours;
    if (loose <= 0) return;
    const auto random = static_cast<std::uint32_t>(cell_word(base, number(u, v)) >> 40);
    const int bonding = bonding_slabs(*law_, loose, random);
    if (bonding == 0) return;
    const float rested = law_->now - layers_->landed[here] + law_->step_hours;
    age = (age * bonded + rested * static_cast<float>(bonding)) / (bonded + static_cast<float>(bonding));
    loose -= bonding;
  });
}

}  // namespace erg
