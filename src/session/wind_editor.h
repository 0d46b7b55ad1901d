// Editing the wind: a list of seasons in which no value is invalid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/errors.h"
#include "forcing/channels.h"
#include "forcing/wind_schedule.h"

namespace erg::session {

/// Edits a schedule where it stands. There is always at least one season; values outside their range are refused.
class WindEditor {
 public:
  /// `standard`: the wind that it goes back to, of one season.
  explicit WindEditor(forcing::WindSchedule& schedule, forcing::WindSchedule standard = {})
      : schedule_(&schedule), standard_(std::move(standard)) {}

  const forcing::WindSchedule& schedule() const { return *schedule_; }
  std::size_t seasons() const { return schedule_->intervals.size(); }
  const forcing::WindInterval& season(std::size_t index) const { return schedule_->intervals.at(index); }
  /// A season at its defaults.
  const forcing::WindInterval& standard() const { return standard_.intervals.front(); }

  /// A copy of the season right behind it; returns the copy's index.
  std::size_t duplicate(std::size_t index);
  /// A season at its defaults at the end; returns its index.
  std::size_t add();
  /// Other seasons in their place; none: nothing changes.
  void replace(std::vector<forcing::WindInterval> seasons);
  /// Removes it; the last one that is left stays. False then.
  bool remove(std::size_t index);
  /// One place up (earlier) or down (later). False at the end of the list.
  bool move_up(std::size_t index);
  bool move_down(std::size_t index);
  /// One season at its defaults: a constant wind.
  void reset();

  /// The declarations of a season's values; their defaults are those of `standard`.
  Declarations columns() const { return forcing::interval_columns(standard()); }
  /// A season's value of one of them, but of the ends of its strength.
  ParameterValue value(std::size_t index, std::string_view key) const;

  // Each says what is wrong with the value, and then nothing has changed.
  std::optional<Mistake> set(std::size_t index, std::string_view key, const ParameterValue& value);
  std::optional<Mistake> set_bearing(std::size_t index, double degrees) { return set(index, "bearing", degrees); }
  /// "270", "W", "nne".
  std::optional<Mistake> set_bearing(std::size_t index, std::string_view text);
  std::optional<Mistake> set_first(std::size_t index, double strength) { return set(index, "first", strength); }
  std::optional<Mistake> set_last(std::size_t index, double strength) { return set(index, "last", strength); }
  /// How much the bearing swings, degrees, and for how many steps a draw holds.
  std::optional<Mistake> set_spread(std::size_t index, double degrees) { return set(index, "spread", degrees); }
  std::optional<Mistake> set_hold(std::size_t index, std::int64_t steps) { return set(index, "hold", steps); }
  std::optional<Mistake> set_steps(std::size_t index, std::int64_t steps) { return set(index, "steps", steps); }
  /// The strength curve's control points; both must lie in the unit square.
  std::optional<Mistake> set_curve(std::size_t index, const BezierCurve& curve) { return set(index, "curve", curve); }

 private:
  forcing::WindSchedule* schedule_;
  forcing::WindSchedule standard_;
};

}  // namespace erg::session
