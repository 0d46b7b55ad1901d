// The wind of all seasons together, for plots: over one cycle, and by where it comes from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "forcing/wind_schedule.h"

namespace erg::session {

/// The wind over one cycle of its seasons.
struct WindCycle {
  std::vector<std::int64_t> steps;          ///< evenly over the cycle
  std::vector<double> strengths;            ///< in each of them, as the model understands it
  std::vector<std::int64_t> season_starts;  ///< first step of each season
  std::int64_t length = 1;                  ///< steps

  /// Where `step` of a run lies in the cycle, in steps.
  std::int64_t position(std::int64_t step) const { return step % length; }
  /// Which season blows then.
  std::size_t season_at(std::int64_t step) const;
};
/// The cycle of a schedule at `samples` steps, two at least.
WindCycle sample_cycle(const forcing::WindSchedule& schedule, std::size_t samples);

/// How much wind comes from where: the sum of strengths over steps, in equal sectors; sector 0 is centred on north. A
/// season with a spread counts by the mean of its swings.
struct WindRose {
  std::vector<double> blown;    ///< steps 0 to now
  std::vector<double> to_blow;  ///< from now to the end
};
/// `now` steps done out of `end`. Long runs are summed by whole cycles. At least 4 `sectors`.
WindRose wind_rose(const forcing::WindSchedule& schedule, std::int64_t now, std::int64_t end, std::size_t sectors = 16);

/// The wind as it blew, step after step: the sum of strengths by where it came from.
struct WindRecord {
  static constexpr std::size_t sectors = 16;  ///< sector 0 is centred on north
  std::array<double, sectors> sums{};

  /// One step more.
  void add(const forcing::Forcing& wind);
  /// What a schedule says of its first steps, for runs that were not watched then.
  static WindRecord of(const forcing::WindSchedule& schedule, std::int64_t steps);
  bool operator==(const WindRecord&) const = default;
};

}  // namespace erg::session
