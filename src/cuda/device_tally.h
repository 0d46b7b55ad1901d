// What kernels have counted, on the processor.
#pragma once

#include <cstdint>
#include <vector>

#include "cuda/device.h"
#include "cuda/device_plan.h"

namespace erg {

/// Slabs counted in a step.
struct SlabCounts {
  std::int64_t of[tallies] = {};
};

inline SlabCounts read_counts(Device& device, const DeviceArray<TallyWord>& tally) {
  SlabCounts counts;
  const std::vector<TallyWord> words = device.fetch(tally.data(), tally.size());
  for (std::size_t k = 0; k < words.size(); ++k) counts.of[k % tallies] += static_cast<std::int64_t>(words[k]);
  return counts;
}

}  // namespace erg
