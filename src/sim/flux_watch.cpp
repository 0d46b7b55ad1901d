#include "sim/flux_watch.h"

#include <algorithm>
#include <utility>

namespace erg::sim {

void FluxWatch::stepped() {
  if (++steps_ < steps_of_mean) return;
  std::swap(counts_, last_counts_);
  std::ranges::fill(counts_.cells(), 0);
  last_steps_ = std::exchange(steps_, 0);
}

Field FluxWatch::mean() const {
  Field field{{.key = "flux",
               .label = "flux",
               .unit = "lifts/step",
               .minimum = 0,
               .maximum = 1,
               .palette = "batlow",
               .meaning = "Slabs or grains lifted from the cell in a step, a mean over the last steps."},
              Grid<float>(counts_.extent())};
  const bool whole = last_steps_ > 0;
  const Grid<std::int32_t>& counts = whole ? last_counts_ : counts_;
  const float share = 1.0f / static_cast<float>(std::max(whole ? last_steps_ : steps_, 1));
  for (std::size_t cell = 0; cell < counts.size(); ++cell) {
    field.values[cell] = static_cast<float>(counts[cell]) * share;
  }
  return field;
}

}  // namespace erg::sim
