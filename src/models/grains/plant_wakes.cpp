#include "models/grains/plant_wakes.h"

#include <algorithm>
#include <cmath>

namespace erg::models {

using forcing::WindFrame;

namespace {

/// The wake of plants along the wind.
class Wake {
 public:
  Wake(const GrainValues& values, const WindFrame& frame, double cell_size)
      : shelter_(values.plant_shelter),
        length_(values.wake_length * values.plant_height / cell_size),
        spread_(values.wake_spread),
        along_u_(frame.tangent * frame.cosine),
        along_v_(frame.cosine) {}

  /// Cells to either side that a wake may touch.
  int reach() const { return static_cast<int>(std::ceil(length_ * (1 + spread_))) + 1; }

  /// The share of the wind left at (du, dv) cells from a cell with this cover.
  double wind_left(double cover, int du, int dv) const {
    if (du == 0 && dv == 0) return 1 - shelter_ * cover;
    const double behind = du * along_u_ + dv * along_v_;
    const double aside = std::abs(du * along_v_ - dv * along_u_);
    if (behind <= 0 || behind >= length_) return 1;
    const double edge = 0.5 + spread_ * behind;
    if (aside >= edge + 0.5) return 1;
    const double inside = std::min(1.0, edge + 0.5 - aside);  // fades over the last cell
    return 1 - shelter_ * cover * inside * (1 - behind / length_);
  }

 private:
  double shelter_;
  double length_;  // cells
  double spread_;
  double along_u_;
  double along_v_;
};

}  // namespace

std::vector<float> plant_shelter(const GrainValues& values, const Terrain& terrain, const Grid<float>& plants,
                                 const WindFrame& frame) {
  std::vector<float> shelter(terrain.extent().cells(), 1.0f);
  const Wake wake(values, frame, terrain.cell_size());
  const bool torus = terrain.boundary() == Boundary::torus;
  const int reach_u = std::min(wake.reach(), frame.width);
  const int reach_v = std::min(wake.reach(), frame.length);
  for (int v = 0; v < frame.length; ++v) {
    for (int u = 0; u < frame.width; ++u) {
      const double cover = std::min(1.0f, plants[frame.cell(u, v)]);
      if (cover <= 0) continue;
      for (int dv = 0; dv <= reach_v; ++dv) {
        for (int du = -reach_u; du <= reach_u; ++du) {
          const double left = wake.wind_left(cover, du, dv);
          const bool inside = u + du >= 0 && u + du < frame.width && v + dv < frame.length;
          if (left >= 1 || (!torus && !inside)) continue;
          float& share =
              shelter[static_cast<std::size_t>(wrap(v + dv, frame.length)) * frame.width + wrap(u + du, frame.width)];
          share = std::min(share, static_cast<float>(left));
        }
      }
    }
  }
  return shelter;
}

}  // namespace erg::models
