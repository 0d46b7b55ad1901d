#include "transport/snow_machine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "core/errors.h"
#include "transport/box_mean.h"
#include "transport/fixed_point.h"

namespace erg {
namespace {

/// What the random words of a step are for; each has a key space of its own.
enum SnowWord : std::uint64_t { fall = 62, bonds, slides };

constexpr int slide_rounds = 2;
constexpr int cells_at_once = 64;  // that are looked over for steep edges together
constexpr std::int64_t most_at_once = 4096;
constexpr int rows_at_once = 64;                // that are followed for shadow together
constexpr std::int32_t no_shadow = -(1 << 24);  // lower than any surface, fixed point

}  // namespace

/// Rows of lines side by side.
struct SnowMachine::ShadowTile {
  int first_u = 0;            ///< column of the first line in the first row
  int drifted[rows_at_once];  ///< columns since then
  std::uint16_t height[rows_at_once][snow_lines];
  std::uint8_t dark[rows_at_once][snow_lines];
};

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
  report_ = {};
  bedrock_ = terrain.bedrock().cells().data();
  mobile_ = terrain.edit_mobile().cells().data();
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
  const SnowKernels& kernels = snow_kernels(instructions_);
  SnowHeights all;
  all.level = bedrock_[0];
  executor_->for_pieces(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    SnowHeights heights;
    heights.level = bedrock_[0];
    for (std::int64_t at = begin; at < end; at += most_at_once) {
      kernels.survey(bedrock_ + at, mobile_ + at, static_cast<int>(std::min(most_at_once, end - at)), heights);
    }
    const std::lock_guard lock(mutex_);
    all.lowest = std::min(all.lowest, heights.lowest);
    all.highest = std::max(all.highest, heights.highest);
    all.most_snow = std::max(all.most_snow, heights.most_snow);
    all.uneven |= heights.uneven;
  });
  low_ = all.lowest;
  high_ = all.highest;
  relief_ = all.uneven != 0;
  if (all.most_snow > highest_terrain || high_ - low_ > highest_terrain) {
    throw InputError("terrain",
                     "it has grown to " + std::to_string(std::max<std::int32_t>(all.most_snow, high_ - low_)) +
                         " slabs, more than " + std::to_string(highest_terrain),
                     "use a larger slab height or less snow");
  }
  height_.resize(cells);
  executor_->for_pieces(static_cast<std::int64_t>(cells), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t at = begin; at < end; at += most_at_once) {
      kernels.raise(bedrock_ + at, mobile_ + at, low_, height_.data() + at,
                    static_cast<int>(std::min(most_at_once, end - at)));
    }
  });
}

void SnowMachine::measure_weather(double shadow_fall) {
  const std::size_t cells = extent_.cells();
  dark_.resize(cells);
  find_shadow(shadow_fall);
  chances_.resize(cells);
  hops_.resize(cells);
  over_.resize(cells);
  longest_mean_hop_ = 0;
  executor_->for_pieces(extent_.ny, [&](std::int64_t begin, std::int64_t end) {
    const std::uint32_t longest = make_weather(static_cast<int>(begin), static_cast<int>(end));
    const std::lock_guard lock(mutex_);
    longest_mean_hop_ = std::max(longest_mean_hop_, longest);
  });
}

/// What the weather of a row is made from, but for the smoothed surface.
SnowWeatherRow SnowMachine::weather_row(int y) const {
  // Half the difference of two neighbours is the slope in slabs a cell.
  const double along = 0.5 * frame_.cosine * law_->slope_scale * (frame_.step_v > 0 ? 1 : -1);
  const double across = 0.5 * frame_.tangent * frame_.cosine * law_->slope_scale * (frame_.step_u > 0 ? 1 : -1);
  const std::size_t here = static_cast<std::size_t>(y) * static_cast<std::size_t>(extent_.nx);
  SnowWeatherRow row;
  row.count = extent_.nx;
  row.slope_by_x = static_cast<float>(along_x() ? along : across);
  row.slope_by_y = static_cast<float>(along_x() ? across : along);
  row.rows = static_cast<float>(frame_.cosine);
  row.landed = layers_->landed.data() + here;
  row.age = layers_->age.data() + here;
  row.surface = height_.data() + here;
  row.dark = dark_.data() + here;
  return row;
}

/// The weather of some rows of the terrain; returns the longest mean hop. The smoothed surface is made row by row
/// beside it, so that it need not go through memory.
std::uint32_t SnowMachine::make_weather(int begin, int end) {
  const bool torus = boundary_ == Boundary::torus;
  const int nx = extent_.nx;
  const auto width = static_cast<std::size_t>(nx);
  const BoxGrid grid{extent_, boundary_, height_.data(), static_cast<std::uint16_t>(high_ - low_),
                     &snow_kernels(instructions_)};
  const int first = torus ? begin - 1 : std::max(begin - 1, 0);
  const int last = torus ? end : std::min(end, extent_.ny - 1);
  const std::unique_ptr<BoxMeans> levels = box_means(grid, radii_.smooth, true, first);
  const std::unique_ptr<BoxMeans> surroundings = box_means(grid, radii_.around, false, begin);
  std::vector<float> rows[3];  // of the smoothed surface, with a place more on either side
  for (std::vector<float>& row : rows) row.resize(width + 2);
  std::vector<float> around(width);
  const auto level = [&](int y) -> std::vector<float>& { return rows[(y - first) % 3]; };
  int made = first;
  std::uint32_t longest = 0;
  for (int y = begin; y < end; ++y) {
    for (; made <= std::min(y + 1, last); ++made) {
      std::vector<float>& row = level(made);
      levels->next(row.data() + 1);
      row[0] = torus ? row[width] : row[1];
      row[width + 1] = torus ? row[1] : row[width];
    }
    surroundings->next(around.data());
    SnowWeatherRow row = weather_row(y);
    row.level = level(y).data() + 1;
    row.south = level(std::max(y - 1, first)).data() + 1;
    row.north = level(std::min(y + 1, last)).data() + 1;
    row.around = around.data();
    const std::size_t here = static_cast<std::size_t>(y) * width;
    row.chances = chances_.data() + here;
    row.hops = hops_.data() + here;
    row.over = over_.data() + here;
    longest = std::max(longest, grid.kernels->weather(*law_, row));
  }
  return longest;
}

void SnowMachine::find_shadow(double shadow_fall) {
  executor_->for_pieces(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t line = begin; line < end; line += snow_lines) {
      shade_lines(static_cast<int>(line), static_cast<int>(std::min<std::int64_t>(end - line, snow_lines)),
                  shadow_fall);
    }
  });
}

/// Follows lines down the wind with the shadow line of all that they have passed, and that of the cell before. Some
/// rows at a time are taken from the terrain with their lines side by side.
void SnowMachine::shade_lines(int first, int lines, double shadow_fall) {
  const bool open = boundary_ == Boundary::open;
  const SnowKernels& kernels = snow_kernels(instructions_);
  const auto fall = [](double slabs) {  // one that is longer than any snow is high shades nothing
    return static_cast<std::int32_t>(std::min<std::int64_t>(fixed_point(slabs), -no_shadow));
  };
  const auto tangent_24 = static_cast<std::int64_t>(frame_.tangent * 0x1p24);
  // Rows before the first one from which a shadow can still reach over the torus edge.
  const double reach = static_cast<double>(high_ - low_) * frame_.cosine / std::max(shadow_fall, 1e-6) + 3;
  const int limit = 2 * frame_.length;
  const int start = open ? 0 : -(reach < limit ? static_cast<int>(reach) : limit);
  std::int32_t far[snow_lines];
  std::int32_t near[snow_lines];
  std::fill(std::begin(far), std::end(far), no_shadow);
  std::fill(std::begin(near), std::end(near), no_shadow);
  ShadowTile tile;
  int end = 0;
  for (int begin = start; begin < frame_.length; begin = end) {
    end = std::min({begin + rows_at_once, begin < 0 ? 0 : frame_.length, frame_.length});
    const auto moved = [&](int row) { return (row * tangent_24 + (std::int64_t{1} << 23)) >> 24; };
    tile.first_u = wrap(static_cast<int>(first + moved(begin)), frame_.width);
    for (int row = begin; row < end; ++row) tile.drifted[row - begin] = static_cast<int>(moved(row) - moved(begin));
    for_tile(begin, end, lines, tile, [&](int k, int line, std::size_t cell, std::ptrdiff_t step, int count) {
      const std::uint16_t* from = height_.data() + cell;
      if (along_x()) {
        const int there = line + tile.drifted[k];
        for (int i = 0; i < count; ++i) tile.height[k + i][there - tile.drifted[k + i]] = from[i * step];
      } else {
        for (int i = 0; i < count; ++i) tile.height[k][line + i] = from[i * step];
      }
    });
    for (int k = 0; k < end - begin; ++k) {
      const int column = (tile.first_u + tile.drifted[k]) % frame_.width;
      if (const int entering = column == 0 ? 0 : frame_.width - column; open && entering < lines) {
        far[entering] = near[entering] = no_shadow;  // it enters over the side, or begins here
      }
      kernels.shade(
          {lines, fall(shadow_fall / frame_.cosine), fall(shadow_fall), tile.height[k], far, near, tile.dark[k]});
    }
    if (begin < 0) continue;
    for_tile(begin, end, lines, tile, [&](int k, int line, std::size_t cell, std::ptrdiff_t step, int count) {
      std::uint8_t* to = dark_.data() + cell;
      if (along_x()) {
        const int there = line + tile.drifted[k];
        for (int i = 0; i < count; ++i) to[i * step] = tile.dark[k + i][there - tile.drifted[k + i]];
      } else {
        for (int i = 0; i < count; ++i) to[i * step] = tile.dark[k][line + i];
      }
    });
  }
}

/// Calls visit(row of the tile, line there, cell of the terrain, step, count) for each piece of cells that lie in the
/// terrain one beside another: lines of a row, or what lines that drift have of a row of the terrain.
template <typename Visit>
void SnowMachine::for_tile(int begin, int end, int lines, const ShadowTile& tile, const Visit& visit) const {
  const auto piece = [&](int k, int line, std::ptrdiff_t step, int count) {
    const int u = (tile.first_u + tile.drifted[k] + line) % frame_.width;
    if (count > 0) visit(k, line, frame_.cell(u, wrap(begin + k, frame_.length)), step, count);
  };
  const int rows = end - begin;
  if (!along_x()) {
    for (int k = 0; k < rows; ++k) {
      const int before_edge = std::min(lines, frame_.width - (tile.first_u + tile.drifted[k]) % frame_.width);
      piece(k, 0, frame_.step_u, before_edge);
      piece(k, before_edge, frame_.step_u, lines - before_edge);
    }
    return;
  }
  int from = 0;
  int to = 0;
  for (int first_line = 0; first_line < lines + tile.drifted[rows - 1]; ++first_line) {
    while (to < rows && first_line >= tile.drifted[to]) ++to;
    while (first_line - tile.drifted[from] >= lines) ++from;
    for (int k = from; k < to;) {  // in pieces between torus edges
      const int next = std::min(to, k + frame_.length - wrap(begin + k, frame_.length));
      piece(k, first_line - tile.drifted[k], frame_.step_v, next - k);
      k = next;
    }
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
  find_steep();
  for (std::uint64_t round = 0; round < slide_rounds; ++round) {
    std::uint32_t order[4] = {0, 1, 2, 3};
    for (std::uint32_t last = 3; last > 0; --last) {
      std::swap(order[last], order[random_below(key_, round, last, slides, last + 1)]);
    }
    for (const std::uint32_t kind : order) slide_class(kind < 2, static_cast<int>(kind & 1));
  }
}

/// Looks at all edges once. Later only those around a slide may become steep.
void SnowMachine::find_steep() {
  const int nx = extent_.nx;
  const int ny = extent_.ny;
  blocks_ = (nx + cells_at_once - 1) / cells_at_once;
  const std::size_t blocks = static_cast<std::size_t>(blocks_) * static_cast<std::size_t>(ny);
  steep_in_row_.assign(blocks, 0);
  steep_to_next_.assign(blocks, 0);
  executor_->for_pieces(ny, [&](std::int64_t begin, std::int64_t end) {
    for (int y = static_cast<int>(begin); y < end; ++y) {
      const std::size_t here = index(0, y);
      const std::size_t next = index(0, y + 1 < ny ? y + 1 : 0);
      for (int x = 0; x < nx; x += cells_at_once) {
        const auto at = static_cast<std::size_t>(x);
        const int count = std::min(cells_at_once, nx - x);
        const std::size_t flag = block(x, y);
        if (steep_edges(here + at, here + at + 1, std::min(count, nx - 1 - x)) != 0) steep_in_row_[flag] = 1;
        if (steep_edges(here + at, next + at, count) != 0) steep_to_next_[flag] = 1;
      }
    }
  });
}

/// A cell's height has changed. Threads may mark a block at the same time, though none looks at it then.
void SnowMachine::mark_steep(int x, int y) {
  const auto mark = [](std::uint8_t& flag) { std::atomic_ref(flag).store(1, std::memory_order_relaxed); };
  mark(steep_in_row_[block(x, y)]);
  if (x > 0) mark(steep_in_row_[block(x - 1, y)]);
  mark(steep_to_next_[block(x, y)]);
  mark(steep_to_next_[block(x, y > 0 ? y - 1 : extent_.ny - 1)]);
}

/// The edges along (or across) the wind that begin at even (odd) places; those over the border come by themselves.
void SnowMachine::slide_class(bool along, int odd) {
  const int count = along ? frame_.length : frame_.width;
  const bool forward = (along ? frame_.step_v : frame_.step_u) > 0;
  const int first = forward ? odd : (count - odd) & 1;  // the terrain's own place at which edges begin
  const bool closes = odd == 1 && boundary_ == Boundary::torus && count > 2;
  const int ny = extent_.ny;
  if (along == along_x()) {
    executor_->for_pieces(ny, [&](std::int64_t begin, std::int64_t end) {
      for (int y = static_cast<int>(begin); y < end; ++y) {
        slide_in_row(y, first);
        if (closes) slide_edge(0, y, extent_.nx - 1, y);
      }
    });
    return;
  }
  executor_->for_pieces((ny - first) / 2, [&](std::int64_t begin, std::int64_t end) {
    for (int k = static_cast<int>(begin); k < end; ++k) slide_to_next(2 * k + first);
  });
  if (closes) slide_to_next(ny - 1);
}

/// The edges of a row that begin at every second place from `first` on.
void SnowMachine::slide_in_row(int y, int first) {
  const std::uint64_t every_second = std::uint64_t{0x5555555555555555} << first;
  for (int x = 0; x + 1 < extent_.nx; x += cells_at_once) {
    std::uint8_t& flag = steep_in_row_[block(x, y)];
    if (flag == 0) continue;
    const std::size_t here = index(x, y);
    std::uint64_t steep = steep_edges(here, here + 1, std::min(cells_at_once, extent_.nx - 1 - x));
    if (steep == 0) flag = 0;
    for (steep &= every_second; steep != 0; steep &= steep - 1) {
      const int from = x + __builtin_ctzll(steep);
      slide_edge(from, y, from + 1, y);
    }
  }
}

/// The edges between a row and the next one.
void SnowMachine::slide_to_next(int y) {
  const int next = y + 1 < extent_.ny ? y + 1 : 0;
  for (int x = 0; x < extent_.nx; x += cells_at_once) {
    std::uint8_t& flag = steep_to_next_[block(x, y)];
    if (flag == 0) continue;
    std::uint64_t steep = steep_edges(index(x, y), index(x, next), std::min(cells_at_once, extent_.nx - x));
    if (steep == 0) flag = 0;
    for (; steep != 0; steep &= steep - 1) {
      const int from = x + __builtin_ctzll(steep);
      slide_edge(from, y, from, next);
    }
  }
}

std::uint64_t SnowMachine::steep_edges(std::size_t a, std::size_t b, int count) const {
  const std::int32_t* ground = relief_ ? bedrock_ : nullptr;
  const auto at = [ground](std::size_t cell) { return ground != nullptr ? ground + cell : nullptr; };
  return snow_kernels(instructions_).find_steep(at(a), mobile_ + a, at(b), mobile_ + b, count, law_->standing);
}

void SnowMachine::slide_edge(int x, int y, int other_x, int other_y) {
  const std::size_t a = index(x, y);
  const std::size_t b = index(other_x, other_y);
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
  mark_steep(x, y);
  mark_steep(other_x, other_y);
}

// --- rest ---

/// Snow falls at random and comes to lie on the lowest of nine cells.
void SnowMachine::let_snow_fall() {
  if (law_->snowfall <= 0) return;
  const std::uint64_t base = random_word(key_, 0, 0, fall);
  fallen_.clear();
  executor_->for_pieces(frame_.width, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::uint32_t> fallen;
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
  const auto key = static_cast<std::uint32_t>(random_word(key_, 0, 0, bonds));
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
