#include "forcing/channels.h"

#include <algorithm>

#include "forcing/bearing.h"

namespace erg::forcing {
namespace {

constexpr Notation bearing_notation{accepted_bearings, parse_bearing, fold_bearing};

Parameter bearing_column(const WindInterval& standard) {
  return {.key = "bearing",
          .label = "Bearing",
          .unit = "deg",
          .default_value = standard.bearing,
          .minimum = -largest_bearing,
          .maximum = largest_bearing,
          .notation = &bearing_notation,
          .meaning = "Where the wind blows from."};
}

Parameter strength_column(const char* key, double standard) {
  return {.key = key,
          .label = "Strength",
          .default_value = standard,
          .minimum = smallest_strength,
          .maximum = largest_strength,
          .meaning =
              "Strength of the wind: cells a hop for slab models, m/s for the others. 0 is a calm: time passes, "
              "and the wind moves nothing."};
}

Parameter spread_column(const WindInterval& standard) {
  return {.key = "spread",
          .label = "Spread",
          .unit = "deg",
          .default_value = standard.spread,
          .minimum = 0,
          .maximum = widest_spread,
          .meaning = "How much the wind swings about its bearing: standard deviation from draw to draw."};
}

Parameter hold_column(const WindInterval& standard) {
  return {.key = "hold",
          .label = "Hold",
          .unit = "steps",
          .default_value = standard.hold,
          .minimum = 1,
          .maximum = most_steps,
          .meaning =
              "Time steps of the season for which the wind stays in one direction before it swings to the "
              "next."};
}

Parameter steps_column(const WindInterval& standard) {
  return {.key = "steps",
          .label = "Steps",
          .default_value = standard.steps,
          .minimum = 1,
          .maximum = most_steps,
          .meaning = "Time steps that the season lasts."};
}

Parameter curve_column() {
  return {.key = "curve",
          .label = "Curve",
          .default_value = BezierCurve{},
          .meaning =
              "The two control points of the Bezier curve along which the value goes from first to last: time "
              "on x, change on y. Absent: a straight line."};
}

Parameter end_column(const Channel& channel, const char* key) {
  Parameter end = channel.declared;
  end.key = key;
  return end;
}

}  // namespace

const std::vector<Channel>& channels() {
  static const std::vector<Channel> all{
      {.declared = {.key = "temperature",
                    .label = "Temperature",
                    .unit = "deg C",
                    .default_value = Weather{}.temperature.first,
                    .minimum = -60,
                    .maximum = 0,
                    .meaning = "Temperature of air and snow; for models that ask for it."},
       .now = &Forcing::temperature,
       .over_run = &Weather::temperature},
      {.declared = {.key = "snowfall",
                    .label = "Snowfall",
                    .unit = "mm/h",
                    .default_value = WindInterval{}.snowfall,
                    .minimum = 0,
                    .maximum = heaviest_snowfall,
                    .meaning = "Snow that falls during the season, as it lies; for models that let it fall."},
       .now = &Forcing::snowfall,
       .of_interval = &WindInterval::snowfall},
  };
  return all;
}

const Channel* find_channel(std::string_view key) {
  const auto found = std::ranges::find_if(channels(), [&](const Channel& one) { return one.declared.key == key; });
  return found == channels().end() ? nullptr : &*found;
}

bool uses_channel(const std::vector<std::string>& keys, const Channel& channel) {
  return std::ranges::find(keys, channel.declared.key) != keys.end();
}

Declarations interval_columns(const WindInterval& standard) {
  Parameters columns{bearing_column(standard),
                     strength_column("strength", standard.first),
                     strength_column("first", standard.first),
                     strength_column("last", standard.last),
                     spread_column(standard),
                     hold_column(standard),
                     steps_column(standard),
                     curve_column()};
  for (const Channel& channel : channels()) {
    if (channel.of_interval != nullptr) columns.push_back(channel.declared);
  }
  return columns;
}

Declarations constant_wind_columns(const WindInterval& standard) {
  return {bearing_column(standard), strength_column("strength", standard.first), spread_column(standard),
          hold_column(standard)};
}

WindInterval interval_of(const ParameterValues& row) {
  WindInterval season;
  season.bearing = row.real("bearing");
  season.first = season.last = row.real("strength");
  season.spread = row.real("spread");
  season.hold = row.integer("hold");
  if (row.find("steps") == nullptr) return season;
  const bool has_first = row.is_set("first");
  const bool has_last = row.is_set("last");
  if (has_first) season.first = season.last = row.real("first");
  if (has_last) season.last = row.real("last");
  if (has_last && !has_first) season.first = season.last;
  season.steps = row.integer("steps");
  season.curve = row.bezier("curve");
  for (const Channel& channel : channels()) {
    if (channel.of_interval != nullptr) season.*channel.of_interval = row.real(channel.declared.key);
  }
  return season;
}

ParameterValues row_of(const WindInterval& season, const Declarations& columns) {
  ParameterValues row(columns);
  const auto set_other = [&row](const char* key, const ParameterValue& value) {
    if (row.find(key) != nullptr && value != row.find(key)->default_value) row.set(key, value);
  };
  row.set("bearing", season.bearing);
  if (season.first == season.last) {
    row.set("strength", season.first);
  } else {
    row.set("first", season.first);
    row.set("last", season.last);
  }
  set_other("spread", season.spread);
  set_other("hold", season.hold);
  if (row.find("steps") != nullptr) row.set("steps", season.steps);
  set_other("curve", season.curve);
  for (const Channel& channel : channels()) {
    if (channel.of_interval != nullptr) set_other(channel.declared.key.c_str(), season.*channel.of_interval);
  }
  return row;
}

void set_in_interval(WindInterval& season, std::string_view key, const ParameterValue& value) {
  const Declarations columns = interval_columns();
  ParameterValues alone(columns);
  alone.set(key, value);
  const bool both = key == "strength";
  if (both || key == "first") season.first = alone.real(key);
  if (both || key == "last") season.last = alone.real(key);
  if (both || key == "first" || key == "last") return;
  ParameterValues row = row_of(season, columns);
  row.set(key, value);
  season = interval_of(row);
}

Declarations course_columns(const Channel& channel) {
  return {end_column(channel, "first"), end_column(channel, "last"), curve_column()};
}

ParameterValues row_of(const Course& course, const Channel& channel) {
  ParameterValues row(course_columns(channel));
  row.set("first", course.first);
  row.set("last", course.last);
  if (course.curve != BezierCurve{}) row.set("curve", course.curve);
  return row;
}

Course course_of(const ParameterValues& row) {
  const double first = row.real("first");
  return {first, row.is_set("last") ? row.real("last") : first, row.bezier("curve")};
}

}  // namespace erg::forcing
