// Slides of SnowMachine: loose snow goes down too steep edges, class by class of edges that share no cell.
#include <algorithm>
#include <atomic>

#include "models/snow/snow_draws.h"
#include "models/snow/snow_machine.h"

namespace erg {
namespace {

constexpr int cells_at_once = 64;  // that are looked over for steep edges together

}  // namespace

void SnowMachine::slide() {
  find_steep();
  for (int round = 0; round < snow_slide_rounds; ++round) {
    SnowEdges order[4];
    draw_snow_slides(key_, round, order);
    for (const SnowEdges& edges : order) slide_class(edges.along, edges.odd);
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
  executor_->parallel_for(ny, [&](std::int64_t begin, std::int64_t end) {
    for (int y = static_cast<int>(begin); y < end; ++y) {
      const std::size_t here = index(0, y);
      find_steep_blocks(here, here + 1, nx - 1, &steep_in_row_[block(0, y)]);
      find_steep_blocks(here, index(0, y + 1 < ny ? y + 1 : 0), nx, &steep_to_next_[block(0, y)]);
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
    executor_->parallel_for(ny, [&](std::int64_t begin, std::int64_t end) {
      for (int y = static_cast<int>(begin); y < end; ++y) {
        slide_in_row(y, first);
        if (closes) slide_edge(0, y, extent_.nx - 1, y);
      }
    });
    return;
  }
  executor_->parallel_for((ny - first) / 2, [&](std::int64_t begin, std::int64_t end) {
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
  return snow_kernels(instructions_)
      .find_steep(bedrock_at(a), mobile_ + a, bedrock_at(b), mobile_ + b, count, law_->standing);
}

void SnowMachine::find_steep_blocks(std::size_t a, std::size_t b, int count, std::uint8_t* flags) const {
  snow_kernels(instructions_)
      .find_steep_blocks(bedrock_at(a), mobile_ + a, bedrock_at(b), mobile_ + b, count, law_->standing, flags);
}

void SnowMachine::slide_edge(int x, int y, int other_x, int other_y) {
  if (!slide_snow(ground_, index(x, y), index(other_x, other_y), *law_)) return;
  mark_steep(x, y);
  mark_steep(other_x, other_y);
}

}  // namespace erg
