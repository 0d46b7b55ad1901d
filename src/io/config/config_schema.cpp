// The JSON Schema of configs, derived from the declarations.
#include <nlohmann/json.hpp>
#include <string>

#include "core/number_text.h"
#include "forcing/bearing.h"
#include "io/config/config_file.h"
#include "io/files/json_print.h"
#include "models/model.h"

namespace erg::io {

using sim::grid_parameters;
using sim::scene_parameters;
using sim::season_hold_parameter;
using sim::season_spread_parameter;
using sim::strength_parameter;

namespace {

using Json = nlohmann::ordered_json;

Json object_schema(Json properties, Json required = Json::array()) {
  Json schema;
  schema["type"] = "object";
  schema["properties"] = std::move(properties);
  if (!required.empty()) schema["required"] = std::move(required);
  schema["additionalProperties"] = false;
  return schema;
}

std::string description(const Parameter& parameter) {
  std::string text = parameter.meaning;
  if (!parameter.unit.empty()) text += " Unit: " + unit_text(parameter.unit) + ".";
  if (parameter.kind == ParameterKind::curve) text += " Vertices [x, y]; x: " + parameter.across + ".";
  if (!parameter.source.empty()) text += " Source: " + parameter.source + ".";
  return text;
}

/// A choice between numbers may be given as a number or as text.
Json choices_schema(const Parameter& parameter) {
  Json choices = Json::array();
  for (const std::string& choice : parameter.choices) {
    const Json value = json_value(parameter, choice);
    choices.push_back(value);
    if (value != Json(choice)) choices.push_back(choice);
  }
  return choices;
}

Json number_schema(double minimum, double maximum) {
  return {{"type", "number"}, {"minimum", json_value(minimum)}, {"maximum", json_value(maximum)}};
}

/// A list of vertices [x, y].
void add_vertices_schema(const Parameter& parameter, Json& schema) {
  Json vertex = {{"type", "array"}, {"items", false}};
  vertex["prefixItems"] = Json::array({number_schema(parameter.across_minimum, parameter.across_maximum),
                                       number_schema(parameter.minimum, parameter.maximum)});
  vertex.update({{"minItems", 2}, {"maxItems", 2}});
  schema["type"] = "array";
  schema["items"] = std::move(vertex);
  schema["minItems"] = 2;
  schema["maxItems"] = most_vertices;
}

Json parameter_schema(const Parameter& parameter) {
  Json schema;
  schema["title"] = parameter.label;
  schema["description"] = description(parameter);
  switch (parameter.kind) {
    case ParameterKind::real:
    case ParameterKind::integer:
      schema["type"] = parameter.kind == ParameterKind::real ? "number" : "integer";
      schema["minimum"] = json_value(parameter.minimum);
      schema["maximum"] = json_value(parameter.maximum);
      break;
    case ParameterKind::boolean:
      schema["type"] = "boolean";
      break;
    case ParameterKind::choice:
      schema["enum"] = choices_schema(parameter);
      break;
    case ParameterKind::path:
      schema["type"] = "string";
      break;
    case ParameterKind::curve:
      add_vertices_schema(parameter, schema);
      break;
  }
  schema["default"] = json_value(parameter, parameter.standard);
  return schema;
}

Json group_schema(const Parameters& declared) {
  Json properties = Json::object();
  for (const Parameter& parameter : declared) properties[parameter.key] = parameter_schema(parameter);
  return object_schema(std::move(properties));
}

Json bearing_schema() {
  Json number;
  number["type"] = "number";
  number["minimum"] = json_value(-largest_bearing);
  number["maximum"] = json_value(largest_bearing);
  Json text;
  text["type"] = "string";
  Json schema;
  schema["title"] = "Bearing";
  schema["description"] = std::string("Where the wind blows from: ") + accepted_bearings + ".";
  schema["anyOf"] = Json::array({number, text});
  schema["default"] = json_value(Season{}.bearing);
  return schema;
}

Json curve_schema() {
  const Json coordinate = {{"type", "number"}, {"minimum", 0}, {"maximum", 1}};
  const Json point = {{"type", "array"}, {"items", coordinate}, {"minItems", 2}, {"maxItems", 2}};
  Json schema = {{"title", "Curve"},
                 {"description",
                  "The two control points of the Bezier curve along which the value goes from first to last: time on "
                  "x, change on y. Absent: a straight line."},
                 {"type", "array"}};
  schema.update({{"items", point}, {"minItems", 2}, {"maxItems", 2}});
  return schema;
}

Json season_schema() {
  const Json strength = parameter_schema(strength_parameter());
  Json properties;
  properties["bearing"] = bearing_schema();
  properties["strength"] = strength;
  properties["first"] = strength;
  properties["last"] = strength;
  properties["spread"] = parameter_schema(season_spread_parameter());
  properties["hold"] = parameter_schema(season_hold_parameter());
  properties["steps"] = parameter_schema(sim::season_steps_parameter());
  properties["curve"] = curve_schema();
  properties["snowfall"] = parameter_schema(sim::season_snowfall_parameter());
  Json schema = object_schema(std::move(properties));
  const Json has_first = {{"required", {"first"}}};
  const Json has_last = {{"required", {"last"}}};
  schema["if"] = {{"required", {"strength"}}};
  schema["then"] = {{"not", {{"anyOf", Json::array({has_first, has_last})}}}};
  return schema;
}

Json wind_schema() {
  Json constant;
  constant["bearing"] = bearing_schema();
  constant["strength"] = parameter_schema(strength_parameter());
  constant["spread"] = parameter_schema(season_spread_parameter());
  constant["hold"] = parameter_schema(season_hold_parameter());
  Json list = {{"type", "array"}, {"minItems", 1}};
  list["items"] = season_schema();
  Json seasons;
  seasons["seasons"] = std::move(list);
  Json schema;
  schema["description"] = "The wind: constant, or a list of seasons that repeats.";
  schema["anyOf"] = Json::array({object_schema(std::move(constant)), object_schema(std::move(seasons), {"seasons"})});
  return schema;
}

Json temperature_schema() {
  const Json degrees = parameter_schema(sim::temperature_parameter());
  Json properties;
  properties["first"] = degrees;
  properties["last"] = degrees;
  properties["curve"] = curve_schema();
  Json schema;
  schema["description"] = "Temperature over the run: a number, or its first and last value and the curve between them.";
  schema["anyOf"] = Json::array({degrees, object_schema(std::move(properties))});
  return schema;
}

/// The defaults of a group that are another model's own.
void add_own_defaults(Json& properties, const std::string& group, const Parameters& own, const Parameters& usual) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].standard == usual[i].standard) continue;
    properties[group]["properties"][own[i].key]["default"] = json_value(own[i], own[i].standard);
  }
}

/// Which parameters a config may have, what of the weather, and where it starts follows from its model.
Json model_rule(const ModelType& type) {
  const ModelStart& start = type.info.start;
  Json properties;
  properties["parameters"]["$ref"] = "#/$defs/" + type.info.key;
  add_own_defaults(properties, "grid", grid_parameters(start), grid_parameters());
  add_own_defaults(properties, "scene", scene_parameters(start), scene_parameters());
  if (start.strength != ModelStart{}.strength) {
    properties["wind"]["properties"]["strength"]["default"] = json_value(start.strength);
  }
  if (start.spread != ModelStart{}.spread) {
    Json& wind = properties["wind"]["properties"];
    wind["spread"]["default"] = json_value(start.spread);
    wind["seasons"]["items"]["properties"]["spread"]["default"] = json_value(start.spread);
  }
  if (!type.info.asks_temperature) properties["temperature"] = false;
  if (!type.info.asks_snowfall) {
    properties["wind"]["properties"]["seasons"]["items"]["properties"]["snowfall"] = false;
  }
  Json rule;
  rule["if"]["properties"]["model"]["const"] = type.info.key;
  rule["then"]["properties"] = std::move(properties);
  return rule;
}

Json text_schema(const char* meaning) { return {{"type", "string"}, {"description", meaning}}; }

}  // namespace

std::string config_schema() {
  Json properties;
  properties["erg"] = {{"description", "Version of the format."}, {"const", sim::config_version}};
  properties["title"] = text_schema("A name for people.");
  properties["description"] = text_schema("What it shows, in a sentence.");
  properties["model"] = {{"description", "The model."}, {"enum", sim::model_keys()}};
  properties["grid"] = group_schema(grid_parameters());
  properties["scene"] = group_schema(scene_parameters());
  properties["parameters"] = {{"description", "The model's own parameters."}, {"type", "object"}};
  properties["wind"] = wind_schema();
  properties["temperature"] = temperature_schema();
  properties["run"] = group_schema(sim::run_parameters());

  Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Erg config";
  schema.update(object_schema(std::move(properties), {"erg", "model"}));
  schema["allOf"] = Json::array();
  schema["$defs"] = Json::object();
  for (const ModelType& type : catalogue()) {
    schema["allOf"].push_back(model_rule(type));
    schema["$defs"][type.info.key] = group_schema(type.parameters);
    schema["$defs"][type.info.key]["title"] = type.info.title;
  }
  return pretty_json(schema);
}

}  // namespace erg::io
