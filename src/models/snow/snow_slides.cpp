// Slides of SnowOnProcessor: loose snow goes down too steep edges, class by class of edges that share no cell.
#include <algorithm>

#include "models/snow/on_processor.h"

namespace erg::models {
namespace {

constexpr int cells_at_once = 64;  // that are looked over for steep edges together

}  // namespace

void SnowOnProcessor::slide() {
  for (int round = 0; round < snow_slide_rounds; ++round) {
    SnowEdges order[4];
    draw_snow_slides(key_, round, order);
    for (const SnowEdges& edges : order) slide_class(edges.along, edges.odd);
  }
}

/// The edges along (or across) the wind that begin at even (odd) places; those over the border come by themselves.
void SnowOnProcessor::slide_class(bool along, int odd) {
  const int count = along ? frame_.length : frame_.width;
  const bool forward = (along ? frame_.step_v : frame_.step_u) > 0;
  const int first = forward ? odd : (count - odd) & 1;  // the terrain's own place at which edges begin
  const bool closes = odd == 1 && planes_.torus && count > 2;
  const int ny = planes_.ny;
  if (along == planes_.along_x) {
    for_rows([&](int y) {
      slide_in_row(y, first);
      if (closes) slide_snow(ground_, planes_.cell(0, y), planes_.cell(planes_.nx - 1, y), *planes_.law);
    });
    return;
  }
  executor_->parallel_for((ny - first) / 2, [&](std::int64_t begin, std::int64_t end) {
    for (int k = static_cast<int>(begin); k < end; ++k) slide_to_next(2 * k + first);
  });
  if (closes) slide_to_next(ny - 1);
}

/// The edges of a row that begin at every second place from `first` on.
void SnowOnProcessor::slide_in_row(int y, int first) {
  const std::uint64_t every_second = std::uint64_t{0x5555555555555555} << first;
  for (int x = 0; x + 1 < planes_.nx; x += cells_at_once) {
    const std::size_t here = planes_.cell(x, y);
    const int count = std::min(cells_at_once, planes_.nx - 1 - x);
    for (auto steep = kernels_.steep(planes_, here, here + 1, count) & every_second; steep != 0; steep &= steep - 1) {
      const std::size_t from = here + static_cast<std::size_t>(__builtin_ctzll(steep));
      slide_snow(ground_, from, from + 1, *planes_.law);
    }
  }
}

/// The edges between a row and the next one.
void SnowOnProcessor::slide_to_next(int y) {
  const std::size_t here = planes_.cell(0, y);
  const std::size_t next = planes_.cell(0, y + 1 < planes_.ny ? y + 1 : 0);
  for (std::size_t x = 0; x < static_cast<std::size_t>(planes_.nx); x += cells_at_once) {
    const int count = std::min(cells_at_once, planes_.nx - static_cast<int>(x));
    for (auto steep = kernels_.steep(planes_, here + x, next + x, count); steep != 0; steep &= steep - 1) {
      const std::size_t at = x + static_cast<std::size_t>(__builtin_ctzll(steep));
      slide_snow(ground_, here + at, next + at, *planes_.law);
    }
  }
}

}  // namespace erg::models
