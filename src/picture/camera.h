// Where a picture is taken from: plain values, kept in files as bookmarks.
#pragma once

#include <array>

namespace erg::picture {

/// A camera that looks at a point of the terrain.
struct Camera {
  std::array<double, 3> target{0, 0, 0};  ///< m: the point in the middle of the picture
  double bearing = 180;       ///< degrees: where the camera stands, seen from the target (180: in the south)
  double altitude = 90;       ///< degrees above the horizon, -90 to 90 (90: straight above)
  double distance = 1;        ///< m from the target
  double opening = 35;        ///< degrees: the angle of view from the picture's lower to its upper edge
  bool orthographic = false;  ///< no perspective: the picture's height is what `opening` spans at the target

  bool operator==(const Camera&) const = default;
};

}  // namespace erg::picture
