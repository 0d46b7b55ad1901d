// The JSON Schema of configs, derived from the declarations.
#include <nlohmann/json.hpp>
#include <string>

#include "core/number_text.h"
#include "forcing/bearing.h"
#include "io/config/config_file.h"
#include "io/files/json_print.h"
#include "models/model.h"

namespace erg::io {

using forcing::Channel;
using forcing::channels;
using models::ModelDefaults;
using models::ModelType;
using sim::grid_parameters;
using sim::scene_parameters;

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
  if (parameter.notation != nullptr) return text.substr(0, text.size() - 1) + ": " + accepted_text(parameter) + ".";
  if (!parameter.unit.empty()) text += " Unit: " + unit_text(parameter.unit) + ".";
  if (parameter.kind() == ParameterKind::curve) text += " Vertices [x, y]; x: " + parameter.x_label + ".";
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

/// A pair [x, y].
Json point_schema(const Json& x, const Json& y) {
  Json point = {{"type", "array"}, {"items", false}};
  point["prefixItems"] = Json::array({x, y});
  point.update({{"minItems", 2}, {"maxItems", 2}});
  return point;
}

/// A list of vertices [x, y].
void add_vertices_schema(const Parameter& parameter, Json& schema) {
  schema["type"] = "array";
  schema["items"] = point_schema(number_schema(parameter.x_minimum, parameter.x_maximum),
                                 number_schema(parameter.minimum, parameter.maximum));
  schema["minItems"] = 2;
  schema["maxItems"] = most_vertices;
}

Json group_schema(const Parameters& declared);

Json parameter_schema(const Parameter& parameter) {
  Json schema;
  schema["title"] = parameter.label;
  schema["description"] = description(parameter);
  if (parameter.notation != nullptr) {  // a number, or text
    const Json text = {{"type", "string"}};
    schema["anyOf"] = Json::array({number_schema(parameter.minimum, parameter.maximum), text});
    schema["default"] = json_value(parameter.default_value);
    return schema;
  }
  switch (parameter.kind()) {
    case ParameterKind::real:
    case ParameterKind::integer:
      schema["type"] = parameter.kind() == ParameterKind::real ? "number" : "integer";
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
    case ParameterKind::bezier:
      schema["type"] = "array";
      schema["items"] = point_schema(number_schema(0, 1), number_schema(0, 1));
      schema.update({{"minItems", 2}, {"maxItems", 2}});
      return schema;
    case ParameterKind::rows:
      schema["type"] = "array";
      schema["items"] = group_schema(parameter.columns);
      schema["minItems"] = json_value(parameter.minimum);
      schema["maxItems"] = json_value(parameter.maximum);
      break;
  }
  schema["default"] = json_value(parameter, parameter.default_value);
  return schema;
}

Json group_schema(const Parameters& declared) {
  Json properties = Json::object();
  for (const Parameter& parameter : declared) properties[parameter.key] = parameter_schema(parameter);
  return object_schema(std::move(properties));
}

Json interval_schema() {
  Json schema = group_schema(forcing::interval_columns());
  const Json has_first = {{"required", {"first"}}};
  const Json has_last = {{"required", {"last"}}};
  schema["if"] = {{"required", {"strength"}}};
  schema["then"] = {{"not", {{"anyOf", Json::array({has_first, has_last})}}}};
  return schema;
}

Json wind_schema() {
  Json list = {{"type", "array"}, {"minItems", 1}};
  list["items"] = interval_schema();
  Json seasons;
  seasons["seasons"] = std::move(list);
  Json schema;
  schema["description"] = "The wind: constant, or a list of seasons that repeats.";
  schema["anyOf"] =
      Json::array({group_schema(forcing::constant_wind_columns()), object_schema(std::move(seasons), {"seasons"})});
  return schema;
}

Json course_schema(const Channel& channel) {
  Json schema;
  schema["description"] =
      channel.declared.label + " over the run: a number, or its first and last value and the curve between them.";
  schema["anyOf"] = Json::array({parameter_schema(channel.declared), group_schema(forcing::course_columns(channel))});
  return schema;
}

/// The defaults of a group that are another model's own.
void add_own_defaults(Json& properties, const std::string& group, const Parameters& own, const Parameters& usual) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    if (own[i].default_value == usual[i].default_value) continue;
    properties[group]["properties"][own[i].key]["default"] = json_value(own[i], own[i].default_value);
  }
}

/// Which parameters a config may have, what of the weather, and where it starts follows from its model.
Json model_rule(const ModelType& type) {
  const ModelDefaults& start = type.info.start;
  Json properties;
  properties["parameters"]["$ref"] = "#/$defs/" + type.info.key;
  add_own_defaults(properties, "grid", grid_parameters(start), grid_parameters());
  add_own_defaults(properties, "scene", scene_parameters(start), scene_parameters());
  if (start.strength != ModelDefaults{}.strength) {
    properties["wind"]["properties"]["strength"]["default"] = json_value(start.strength);
  }
  if (start.spread != ModelDefaults{}.spread) {
    Json& wind = properties["wind"]["properties"];
    wind["spread"]["default"] = json_value(start.spread);
    wind["seasons"]["items"]["properties"]["spread"]["default"] = json_value(start.spread);
  }
  for (const Channel& channel : channels()) {
    if (forcing::uses_channel(type.info.channels, channel)) continue;
    Json& refused = channel.over_run != nullptr
                        ? properties[channel.declared.key]
                        : properties["wind"]["properties"]["seasons"]["items"]["properties"][channel.declared.key];
    refused = false;
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
  for (const Channel& channel : channels()) {
    if (channel.over_run != nullptr) properties[channel.declared.key] = course_schema(channel);
  }
  properties["run"] = group_schema(sim::run_parameters());

  Json schema;
  schema["$schema"] = "https://json-schema.org/draft/2020-12/schema";
  schema["title"] = "Erg config";
  schema.update(object_schema(std::move(properties), {"erg", "model"}));
  schema["allOf"] = Json::array();
  schema["$defs"] = Json::object();
  for (const ModelType& type : models::catalogue()) {
    schema["allOf"].push_back(model_rule(type));
    schema["$defs"][type.info.key] = group_schema(type.parameters);
    schema["$defs"][type.info.key]["title"] = type.info.title;
  }
  return pretty_json(schema);
}

}  // namespace erg::io
