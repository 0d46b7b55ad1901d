// What the weather brings, as data: one declaration for each of its values. Config files, `--set`, the schema, the
// window and the comparison of runs are derived from them. To add one, give it a member of Forcing and one of
// WindInterval or Weather, and its line in channels.cpp; the models that use it name its key (ModelInfo::channels).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/bezier.h"
#include "core/parameters.h"
#include "core/units.h"

namespace erg::forcing {

/// A value over time: from a first to a last along a curve that people bend.
struct Course {
  double first = 0;
  double last = 0;
  BezierCurve curve;

  /// `share` of the time that is past, 0 to 1 (outside: as at the nearer end).
  double at(double share) const { return first + (last - first) * curve.at(share); }
  bool is_constant() const { return first == last; }
  bool operator==(const Course&) const = default;
};

/// One season: the wind blows from one bearing for `steps` time steps, and its strength goes from `first` to `last`
/// along a curve. Strength is in cells per hop for slab models, m/s for the others. A real wind varies about its mean
/// bearing: with a `spread` each draw of `hold` steps has a bearing of its own.
struct WindInterval {
  double bearing = 270;  ///< degrees, where it blows from (the mean)
  double first = 5;
  double last = 5;
  std::int64_t steps = 1;
  BezierCurve curve;
  double snowfall = 0;    ///< mm of snow an hour, for snow models
  double spread = 0;      ///< standard deviation of the bearing from draw to draw, degrees
  std::int64_t hold = 4;  ///< steps of the season for which a draw holds
  bool operator==(const WindInterval&) const = default;
};

/// What runs over all of a run, whatever the seasons.
struct Weather {
  Course temperature{-10, -10, {}};  ///< deg C
  bool operator==(const Weather&) const = default;
};

/// The wind of one time step, and what comes with it.
struct Forcing {
  double bearing = 270;
  double strength = 5;
  double temperature = -10;  ///< deg C
  double snowfall = 0;       ///< mm of snow an hour
  double swing = 0;          ///< degrees by which `bearing` lies clockwise of the season's
  /// The bearing about which the season's wind swings.
  double mean_bearing() const { return fold_bearing(bearing - swing); }
  bool operator==(const Forcing&) const = default;
};

/// A value that comes with the wind: a number for each season, or a course over the run.
struct Channel {
  Parameter declared;
  double Forcing::*now = nullptr;               ///< where a step finds it
  double WindInterval::*of_interval = nullptr;  ///< one of these two: in the wind's seasons
  Course Weather::*over_run = nullptr;          ///< or a key of the config
};

/// All of them, in the order in which people meet them.
const std::vector<Channel>& channels();
/// The channel with this key, or nullptr.
const Channel* find_channel(std::string_view key);
/// Whether a key is among those that a model uses.
bool uses_channel(const std::vector<std::string>& keys, const Channel& channel);

/// Smallest and largest strength that a season may have (cells a hop, or m/s). 0 is a calm: time passes, nothing moves.
inline constexpr double smallest_strength = 0;
inline constexpr double largest_strength = 8192;
/// The heaviest snowfall that a season may have, mm of snow an hour.
inline constexpr double heaviest_snowfall = 200;
/// The widest spread that a season may have, degrees.
inline constexpr double widest_spread = 60;
/// The most steps of a run, and of a season.
inline constexpr std::int64_t most_steps = 1'000'000'000;

/// The declarations of a season as a row of a list: bearing, strength (or first and last), spread, hold, steps, curve,
/// and the channels that each season has. The defaults are those of `standard`.
Declarations interval_columns(const WindInterval& standard = {});
/// Those of a constant wind: bearing, strength, spread, hold.
Declarations constant_wind_columns(const WindInterval& standard = {});
/// The season that a row says (of either). One end of the strength alone stands for both.
WindInterval interval_of(const ParameterValues& row);
/// The way back. Set are the values that a reader wants to see: bearing, strength, steps, and what is not the default.
/// Throws InputError for values out of range.
ParameterValues row_of(const WindInterval& season, const Declarations& columns);

/// Gives a season one value of such a row: `strength` is both ends of it, `first` and `last` one. Throws InputError.
void set_in_interval(WindInterval& season, std::string_view key, const ParameterValue& value);

/// The declarations of a course with a channel's range: first, last, curve.
Declarations course_columns(const Channel& channel);
/// A course as such a row; throws InputError for values out of range.
ParameterValues row_of(const Course& course, const Channel& channel);
/// The course that a row says. A `first` alone stands for both ends.
Course course_of(const ParameterValues& row);

}  // namespace erg::forcing
