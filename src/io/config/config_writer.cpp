// From a Config to the text of a file.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/config/config_file.h"
#include "io/files/json_print.h"
#include "models/model.h"

namespace erg::io {

using forcing::Channel;
using forcing::channels;
using forcing::Course;
using forcing::row_of;
using forcing::uses_channel;
using forcing::WindInterval;
using forcing::WindSchedule;
using models::ModelInfo;

namespace {

using Json = nlohmann::ordered_json;

/// Values that are written though they are at their defaults, because a reader looks for them.
constexpr std::array<std::string_view, 5> always_written{"grid.nx", "grid.ny", "scene.kind", "run.steps", "run.seed"};

/// Values that mean something else where they are absent: they are written if they were set, be it to their defaults.
constexpr std::array<std::string_view, 2> written_if_set{"scene.image_low", "scene.image_high"};

Json group_json(const std::string& group, const ParameterValues& values) {
  Json json = Json::object();
  for (const Parameter& parameter : values.declared()) {
    const std::string full_key = group + "." + parameter.key;
    const bool always = std::ranges::find(always_written, full_key) != always_written.end() ||
                        (std::ranges::find(written_if_set, full_key) != written_if_set.end() &&
                         values.is_set(parameter.key) && values.is_active(parameter));
    if (always || !values.is_default(parameter.key)) {
      json[parameter.key] = json_value(parameter, values.value(parameter.key));
    }
  }
  return json;
}

/// A reader refuses what the model does not use.
WindInterval used_of(WindInterval season, const ModelInfo& model) {
  for (const Channel& channel : channels()) {
    if (channel.of_interval == nullptr || uses_channel(model.channels, channel)) continue;
    season.*channel.of_interval = std::get<double>(channel.declared.default_value);
  }
  return season;
}

Json course_json(const Course& course, const Channel& channel) {
  if (course.is_constant() && course.curve == BezierCurve{}) return json_value(course.first);
  return row_json(row_of(course, channel));
}

Json wind_json(const WindSchedule& wind, const ModelInfo& model) {
  const WindInterval standard = sim::starting_wind(model.start).intervals.front();
  const WindInterval& only = wind.intervals.front();
  WindSchedule constant = WindSchedule::constant(only.bearing, only.first);
  constant.intervals.front().spread = only.spread;
  constant.intervals.front().hold = only.hold;
  if (wind == constant) return row_json(row_of(only, forcing::constant_wind_columns(standard)));
  const Declarations columns = forcing::interval_columns(standard);
  Json json;
  json["seasons"] = Json::array();
  for (const WindInterval& season : wind.intervals) {
    json["seasons"].push_back(row_json(row_of(used_of(season, model), columns)));
  }
  return json;
}

}  // namespace

std::string config_text(const sim::Config& config) {
  const ModelInfo& asking = models::find_model(config.model).info;  // a reader refuses what it does not ask for
  Json json;
  json["erg"] = sim::config_version;
  if (!config.title.empty()) json["title"] = config.title;
  if (!config.description.empty()) json["description"] = config.description;
  json["model"] = config.model;
  for (const sim::ConfigGroup& group : sim::config_groups()) {
    if (group.key == "run") {
      json["wind"] = wind_json(config.wind, asking);
      for (const Channel& channel : channels()) {
        if (channel.over_run == nullptr || !uses_channel(asking.channels, channel)) continue;
        const Course& course = config.weather.*channel.over_run;
        if (course != forcing::Weather{}.*channel.over_run) json[channel.declared.key] = course_json(course, channel);
      }
    }
    Json values = group_json(group.key, config.*group.values);
    if (!values.empty()) json[group.key] = std::move(values);
  }
  return pretty_json(json);
}

}  // namespace erg::io
