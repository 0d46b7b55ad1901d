#include "transport/snow_machine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

#include "transport/fixed_point.h"

namespace erg {
namespace {

constexpr int cells_at_once = 64;  // that are looked over for steep edges together

/// Raises a number that other threads raise.
template <typename Number>
void raise(std::atomic<Number>& most, Number value) {
  for (Number seen = most; value > seen && !most.compare_exchange_weak(seen, value);) {
  }
}

}  // namespace

StepReport SnowMachine::step(Terrain& terrain, SnowLayers& layers, const SnowLaw& law, SnowRadii radii,
                             double shadow_fall, const WindNow& wind, StepKey key, Executor& executor) {
  law_ = &law;
  executor_ = &executor;
  layers_ = &layers;
  extent_ = terrain.extent();
  boundary_ = terrain.boundary();
  inflow_ = boundary_ == Boundary::open ? terrain.inflow() : 0;
  radii_ = radii;
  frame_ = wind_frame(extent_, wind.bearing);
  key_ = key;
  report_ = {};
  bedrock_ = terrain.bedrock().cells().data();
  mobile_ = terrain.edit_mobile().cells().data();
  ground_ = {
      frame_.width, frame_.length, boundary_ == Boundary::torus, frame_.origin,       frame_.step_u, frame_.step_v,
      bedrock_,     mobile_,       layers.loose.data(),          layers.landed.data()};
  measure_heights();
  measure_weather(shadow_fall);
  if (executor.sub_sweeps() == 0) {
    fly_one_by_one();
  } else {
    fly_in_sweeps();
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

// --- weather ---

void SnowMachine::measure_heights() {
  const std::size_t cells = extent_.cells();
  height_.resize(cells);
  std::atomic<std::int32_t> highest{std::numeric_limits<std::int32_t>::min()};
  std::atomic<std::int32_t> deepest{std::numeric_limits<std::int32_t>::min()};  // the lowest surface, its sign turned
  std::atomic<std::int32_t> most{0};
  std::atomic<std::int32_t> any_relief{0};
  executor_->for_pieces(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    std::int32_t low = std::numeric_limits<std::int32_t>::max();
    std::int32_t high = std::numeric_limits<std::int32_t>::min();
    std::int32_t snow = 0;
    std::int32_t uneven = 0;
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const std::int32_t here = surface(k);
      height_[k] = static_cast<std::uint32_t>(here);
      low = std::min(low, here);
      high = std::max(high, here);
      snow = std::max(snow, mobile_[k]);
      uneven |= bedrock_[k] ^ bedrock_[0];
    }
    raise(highest, high);
    raise(deepest, -low);
    raise(most, snow);
    if (uneven != 0) any_relief = 1;
  });
  low_ = -deepest;
  high_ = highest;
  relief_ = any_relief != 0;
  check_snow_height(most, high_ - low_);
  executor_->for_pieces(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    const auto low = static_cast<std::uint32_t>(low_);
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) height_[k] -= low;
  });
}

void SnowMachine::measure_weather(double shadow_fall) {
  const std::size_t cells = extent_.cells();
  const auto most = static_cast<std::uint32_t>(high_ - low_);
  means_.measure(extent_, boundary_, radii_.around, false, height_, most, around_, *executor_);
  means_.measure(extent_, boundary_, radii_.smooth, true, height_, most, level_, *executor_);
  dark_.resize(cells);
  find_shadow(shadow_fall);
  chances_.resize(cells);
  hops_.resize(cells);
  over_.resize(cells);
  std::atomic<std::uint32_t> longest{0};
  executor_->for_pieces(extent_.ny, [&](std::int64_t begin, std::int64_t end) {
    std::uint32_t longest_here = 0;
    for (std::int64_t y = begin; y < end; ++y) {
      longest_here = std::max(longest_here, make_weather(static_cast<int>(y)));
    }
    raise(longest, longest_here);
  });
  longest_mean_hop_ = longest;
}

/// The weather of a row of the terrain; returns the longest mean hop.
std::uint32_t SnowMachine::make_weather(int y) {
  const bool torus = boundary_ == Boundary::torus;
  const int nx = extent_.nx;
  const int ny = extent_.ny;
  const auto row_start = [nx](int row) { return static_cast<std::size_t>(row) * static_cast<std::size_t>(nx); };
  const std::size_t south = row_start(torus ? wrap(y - 1, ny) : std::max(y - 1, 0));
  const std::size_t north = row_start(torus ? wrap(y + 1, ny) : std::min(y + 1, ny - 1));
  // Half the difference of two neighbours is the slope in slabs a cell.
  const double along = 0.5 * frame_.cosine * law_->slope_scale * (frame_.step_v > 0 ? 1 : -1);
  const double across = 0.5 * frame_.tangent * frame_.cosine * law_->slope_scale * (frame_.step_u > 0 ? 1 : -1);
  const auto cells = [&](int x, int count, int west, int east) {
    const std::size_t here = row_start(y) + static_cast<std::size_t>(x);
    SnowWeatherRow row;
    row.count = count;
    row.slope_by_x = static_cast<float>(along_x() ? along : across);
    row.slope_by_y = static_cast<float>(along_x() ? across : along);
    row.rows = static_cast<float>(frame_.cosine);
    row.level = level_.data() + here;
    row.west = level_.data() + row_start(y) + west;
    row.east = level_.data() + row_start(y) + east;
    row.south = level_.data() + south + x;
    row.north = level_.data() + north + x;
    row.around = around_.data() + here;
    row.landed = layers_->landed.data() + here;
    row.age = layers_->age.data() + here;
    row.surface = height_.data() + here;
    row.dark = dark_.data() + here;
    row.chances = chances_.data() + here;
    row.hops = hops_.data() + here;
    row.over = over_.data() + here;
    return snow_kernels(instructions_).weather(*law_, row);
  };
  std::uint32_t longest = cells(0, 1, torus ? nx - 1 : 0, std::min(1, nx - 1));
  if (nx > 2) longest = std::max(longest, cells(1, nx - 2, 0, 2));
  if (nx > 1) longest = std::max(longest, cells(nx - 1, 1, nx - 2, torus ? 0 : nx - 1));
  return longest;
}

void SnowMachine::find_shadow(double shadow_fall) {
  executor_->for_pieces(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    // Where lines lie in memory a few are followed at a time, else all side by side.
    const int step = along_x() ? 16 : static_cast<int>(end - begin);
    for (int line = static_cast<int>(begin); line < end; line += step) {
      shade_lines(line, std::min(line + step, static_cast<int>(end)), shadow_fall);
    }
  });
}

/// Follows lines down the wind with the shadow line of all that they have passed, and that of the cell before.
void SnowMachine::shade_lines(int first, int end, double shadow_fall) {
  constexpr std::int64_t no_line = std::numeric_limits<std::int64_t>::min() / 4;
  const bool open = boundary_ == Boundary::open;
  const SnowShadow shadow = snow_shadow(shadow_fall, frame_.tangent, frame_.cosine, open, frame_.length, high_ - low_);
  std::vector<std::int64_t> far(static_cast<std::size_t>(end - first), no_line);
  std::vector<std::int64_t> near = far;
  std::int64_t sideways = shadow.sideways(shadow.start);
  int first_u = wrap(static_cast<int>(first + sideways), frame_.width);
  int v = wrap(shadow.start, frame_.length);
  for (int row = shadow.start; row < frame_.length; ++row, v = v + 1 == frame_.length ? 0 : v + 1) {
    if (const std::int64_t now = shadow.sideways(row); now != sideways) {
      sideways = now;
      if (++first_u == frame_.width) first_u = 0;
    }
    int u = first_u;
    for (std::size_t line = 0; line < far.size(); ++line) {
      if (open && u == 0) far[line] = near[line] = no_line;  // enters over the side, or begins here
      const std::size_t here = cell(u, v);
      const std::int64_t height = static_cast<std::int64_t>(height_[here]) << fixed_point_bits;
      if (row >= 0) dark_[here] = height < std::max(far[line], near[line]) ? 1 : 0;
      far[line] = std::max(height, far[line]) - shadow.fall_far;
      near[line] = height - shadow.fall_near;
      if (++u == frame_.width) u = 0;
    }
  }
}

// --- flights ---

void SnowMachine::fly_in_sweeps() {
  SnowFlightPlan plan;
  plan.law = law_;
  plan.frame = frame_;
  plan.extent = extent_;
  plan.boundary = boundary_;
  plan.inflow = inflow_;
  plan.key = key_;
  plan.sweeps = executor_->sub_sweeps();
  plan.bedrock = bedrock_;
  plan.mobile = mobile_;
  plan.loose = layers_->loose.data();
  plan.landed = layers_->landed.data();
  plan.chances = chances_.data();
  plan.hops = hops_.data();
  plan.over = over_.data();
  plan.longest_mean_hop = longest_mean_hop_;
  plan.relief = relief_;
  plan.lift_counts = executor_->lift_counts();
  report_ = flights_.fly(plan, instructions_, *executor_);
}

// --- slides ---

void SnowMachine::slide() {
  for (int round = 0; round < snow_slide_rounds; ++round) {
    SnowEdges order[4];
    draw_snow_slides(key_, round, order);
    for (const SnowEdges& edges : order) slide_class(edges.along, edges.odd);
  }
}

/// The edges along (or across) the wind that begin at even (odd) places; those over the border come by themselves.
void SnowMachine::slide_class(bool along, int odd) {
  const int count = along ? frame_.length : frame_.width;
  const bool forward = (along ? frame_.step_v : frame_.step_u) > 0;
  const int first = forward ? odd : (count - odd) & 1;  // the terrain's own place at which edges begin
  const bool closes = odd == 1 && boundary_ == Boundary::torus && count > 2;
  const int ny = extent_.ny;
  const auto nx = static_cast<std::size_t>(extent_.nx);
  if (along == along_x()) {
    executor_->for_pieces(ny, [&](std::int64_t begin, std::int64_t end) {
      for (auto y = static_cast<std::size_t>(begin); y < static_cast<std::size_t>(end); ++y) {
        slide_in_row(y * nx, first);
        if (closes) slide_snow(ground_, y * nx, y * nx + nx - 1, *law_);
      }
    });
    return;
  }
  executor_->for_pieces((ny - first) / 2, [&](std::int64_t begin, std::int64_t end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const std::size_t row = (2 * k + static_cast<std::size_t>(first)) * nx;
      slide_between_rows(row, row + nx);
    }
  });
  if (closes) slide_between_rows(static_cast<std::size_t>(ny - 1) * nx, 0);
}

/// The edges of a row that begin at every second place from `first` on.
void SnowMachine::slide_in_row(std::size_t row, int first) {
  for (int x = 0; x + 1 < extent_.nx; x += cells_at_once) {
    const int count = std::min(cells_at_once, extent_.nx - 1 - x);
    const std::size_t here = row + static_cast<std::size_t>(x);
    if (!any_steep(here, here + 1, count)) continue;
    for (int k = first; k < count; k += 2) {
      slide_snow(ground_, here + static_cast<std::size_t>(k), here + static_cast<std::size_t>(k) + 1, *law_);
    }
  }
}

void SnowMachine::slide_between_rows(std::size_t a, std::size_t b) {
  for (int x = 0; x < extent_.nx; x += cells_at_once) {
    const int count = std::min(cells_at_once, extent_.nx - x);
    const auto start = static_cast<std::size_t>(x);
    if (!any_steep(a + start, b + start, count)) continue;
    for (std::size_t k = start; k < start + static_cast<std::size_t>(count); ++k)
      slide_snow(ground_, a + k, b + k, *law_);
  }
}

bool SnowMachine::any_steep(std::size_t a, std::size_t b, int count) const {
  const std::int32_t* ground = relief_ ? bedrock_ : nullptr;
  const auto at = [ground](std::size_t cell) { return ground != nullptr ? ground + cell : nullptr; };
  return snow_kernels(instructions_).any_steep(at(a), mobile_ + a, at(b), mobile_ + b, count, law_->standing);
}

// --- rest ---

/// Snow falls at random and comes to lie on the lowest of nine cells.
void SnowMachine::let_snow_fall() {
  if (law_->snowfall <= 0) return;
  const std::uint64_t base = snowfall_word(key_);
  fallen_.clear();
  executor_->for_pieces(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::uint32_t> fallen;
    for (int u = static_cast<int>(begin); u < end; ++u) {
      for (int v = 0; v < frame_.length; ++v) {
        const std::uint64_t word = snow_cell_word(base, ground_.number(u, v));
        const int slabs = falling_slabs(*law_, word);
        if (slabs == 0) continue;
        const std::size_t lowest = lowest_of_nine(ground_, u, v, word);
        fallen.insert(fallen.end(), static_cast<std::size_t>(slabs), static_cast<std::uint32_t>(lowest));
      }
    }
    const std::lock_guard lock(mutex_);
    fallen_.push_back(std::move(fallen));
  });
  for (const std::vector<std::uint32_t>& fallen : fallen_) {
    report_.slabs_in += static_cast<std::int64_t>(fallen.size());
    for (const std::uint32_t here : fallen) {
      ++mobile_[here];
      ++layers_->loose[here];
      layers_->landed[here] = law_->now;
    }
  }
}

/// Loose snow bonds from below; bonded snow grows older.
void SnowMachine::rest() {
  const std::uint32_t key = bonding_key(key_);
  const auto nx = static_cast<std::size_t>(extent_.nx);
  const std::int64_t next_by_v = frame_.step_v > 0 ? 1 : -1;
  const std::int64_t next_by_u = frame_.step_u > 0 ? frame_.length : -frame_.length;
  const std::int64_t by_x = along_x() ? next_by_v : next_by_u;
  const std::int64_t by_y = along_x() ? next_by_u : next_by_v;
  const std::int64_t first = (frame_.step_v > 0 ? 0 : frame_.length - 1) +
                             (frame_.step_u > 0 ? 0 : std::int64_t{frame_.width - 1} * frame_.length);
  executor_->for_pieces(extent_.ny, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t y = begin; y < end; ++y) {
      const std::size_t start = static_cast<std::size_t>(y) * nx;
      SnowRestRow row;
      row.count = extent_.nx;
      row.key = key;
      row.number = static_cast<std::uint32_t>(first + y * by_y);
      row.next_number = static_cast<std::uint32_t>(by_x);
      row.mobile = mobile_ + start;
      row.landed = layers_->landed.data() + start;
      row.loose = layers_->loose.data() + start;
      row.age = layers_->age.data() + start;
      row.shown_loose = layers_->shown_loose.data() + start;
      row.shown_bonded = layers_->shown_bonded.data() + start;
      snow_kernels(instructions_).rest(*law_, row);
    }
  });
}

}  // namespace erg
