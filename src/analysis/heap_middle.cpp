#include "analysis/heap_middle.h"

#include <algorithm>
#include <vector>

namespace erg::analysis {

double heap_middle(const Grid<std::int32_t>& mobile, int reach) {
  std::vector<double> lines(static_cast<std::size_t>(mobile.nx()));
  for (int y = 0; y < mobile.ny(); ++y) {
    for (int x = 0; x < mobile.nx(); ++x) lines[static_cast<std::size_t>(x)] += mobile(x, y);
  }
  const auto thickest = static_cast<int>(std::ranges::max_element(lines) - lines.begin());
  double sum = 0;
  double moment = 0;
  for (int off = -reach; off <= reach; ++off) {
    const double line = lines[static_cast<std::size_t>(wrap(thickest + off, mobile.nx()))];
    sum += line;
    moment += off * line;
  }
  return sum > 0 ? thickest + moment / sum : thickest;
}

}  // namespace erg::analysis
