// From a Config to the text of a file.
#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "io/config_file.h"
#include "io/json_print.h"
#include "models/model.h"

namespace erg {
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

Json point_json(const CurvePoint& point) { return Json::array({json_value(point.x), json_value(point.y)}); }

void add_curve(Json& json, const BezierCurve& curve) {
  if (curve == BezierCurve{}) return;
  json["curve"] = Json::array({point_json(curve.first), point_json(curve.second)});
}

/// What differs from the model's own wind.
void add_swing(Json& json, const Season& season, const ModelInfo& model) {
  if (season.spread != model.start.spread) json["spread"] = json_value(season.spread);
  if (season.hold != Season{}.hold) json["hold"] = season.hold;
}

Json season_json(const Season& season, const ModelInfo& model) {
  Json json;
  json["bearing"] = json_value(season.bearing);
  if (season.first == season.last) {
    json["strength"] = json_value(season.first);
  } else {
    json["first"] = json_value(season.first);
    json["last"] = json_value(season.last);
  }
  add_swing(json, season, model);
  json["steps"] = season.steps;
  if (model.asks_snowfall && season.snowfall != 0) json["snowfall"] = json_value(season.snowfall);
  add_curve(json, season.curve);
  return json;
}

Json temperature_json(const Temperature& temperature) {
  if (temperature.first == temperature.last && temperature.curve == BezierCurve{}) return json_value(temperature.first);
  Json json;
  json["first"] = json_value(temperature.first);
  json["last"] = json_value(temperature.last);
  add_curve(json, temperature.curve);
  return json;
}

Json wind_json(const Regime& wind, const ModelInfo& model) {
  const Season& only = wind.seasons.front();
  Json json;
  Regime constant = Regime::constant(only.bearing, only.first);
  constant.seasons.front().spread = only.spread;
  constant.seasons.front().hold = only.hold;
  if (wind == constant) {
    json["bearing"] = json_value(only.bearing);
    json["strength"] = json_value(only.first);
    add_swing(json, only, model);
    return json;
  }
  json["seasons"] = Json::array();
  for (const Season& season : wind.seasons) json["seasons"].push_back(season_json(season, model));
  return json;
}

}  // namespace

std::string config_text(const Config& config) {
  const ModelInfo& asking = find_model(config.model).info;  // a reader refuses what it does not ask for
  Json json;
  json["erg"] = config_version;
  if (!config.title.empty()) json["title"] = config.title;
  if (!config.description.empty()) json["description"] = config.description;
  json["model"] = config.model;
  for (const ConfigGroup& group : config_groups()) {
    if (group.key == "run") {
      json["wind"] = wind_json(config.wind, asking);
      if (asking.asks_temperature && config.temperature != Temperature{})
        json["temperature"] = temperature_json(config.temperature);
    }
    Json values = group_json(group.key, config.*group.values);
    if (!values.empty()) json[group.key] = std::move(values);
  }
  return pretty_json(json);
}

}  // namespace erg
