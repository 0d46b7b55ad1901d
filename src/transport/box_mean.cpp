#include "transport/box_mean.h"

#include <algorithm>

namespace erg {
namespace {

/// Row or column number `at` of `count`, which may lie beyond the edges.
int folded(int at, int count, Boundary boundary) {
  return boundary == Boundary::torus ? wrap(at, count) : std::clamp(at, 0, count - 1);
}

}  // namespace

void box_sum(Extent extent, Boundary boundary, int radius, const std::vector<std::int64_t>& in,
             std::vector<std::int64_t>& scratch, std::vector<std::int64_t>& out, Executor& executor) {
  const int nx = extent.nx;
  const int ny = extent.ny;
  const auto row = [nx](int y) { return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx); };
  scratch.resize(in.size());
  out.resize(in.size());
  executor.for_pieces(ny, [&](std::int64_t begin, std::int64_t end) {
    for (int y = static_cast<int>(begin); y < end; ++y) {
      const std::int64_t* from = in.data() + row(y);
      std::int64_t* to = scratch.data() + row(y);
      std::int64_t sum = 0;
      for (int x = -radius; x <= radius; ++x) sum += from[folded(x, nx, boundary)];
      for (int x = 0; x < nx; ++x) {
        to[x] = sum;
        const int enters = x + radius + 1;
        const int leaves = x - radius;
        sum += enters < nx ? from[enters] : from[folded(enters, nx, boundary)];
        sum -= leaves >= 0 ? from[leaves] : from[folded(leaves, nx, boundary)];
      }
    }
  });
  executor.for_pieces(ny, [&](std::int64_t begin, std::int64_t end) {
    std::vector<std::int64_t> sums(static_cast<std::size_t>(nx));
    const auto add = [&](int y, std::int64_t sign) {
      const std::int64_t* from = scratch.data() + row(folded(y, ny, boundary));
      for (int x = 0; x < nx; ++x) sums[static_cast<std::size_t>(x)] += sign * from[x];
    };
    const int first = static_cast<int>(begin);
    for (int y = first - radius; y <= first + radius; ++y) add(y, 1);
    for (int y = first; y < end; ++y) {
      std::copy(sums.begin(), sums.end(), out.begin() + static_cast<std::ptrdiff_t>(row(y)));
      add(y + radius + 1, 1);
      add(y - radius, -1);
    }
  });
}

}  // namespace erg
