// The way of a grain, for pictures.
#pragma once

#include <array>
#include <vector>

namespace erg {

/// Points (m east, m north, m up) to be joined by lines.
using Trajectory = std::vector<std::array<float, 3>>;

}  // namespace erg
