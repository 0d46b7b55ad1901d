#include "io/files/json_print.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace erg::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t line_width = 100;

std::string scalar(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::string on_one_line(const Json& value) {
  if (!value.is_structured()) return scalar(value);
  std::string text;
  for (const auto& [key, element] : value.items()) {
    if (!text.empty()) text += ", ";
    if (value.is_object()) text += scalar(key) + ": ";
    text += on_one_line(element);
  }
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

/// `column` is where the value starts on its line.
std::string laid_out(const Json& value, std::size_t indent, std::size_t column) {
  std::string flat = on_one_line(value);
  const bool outermost = column == 0;
  if (!value.is_structured() || value.empty() || (!outermost && column + flat.size() < line_width)) return flat;
  const std::string margin(indent + 2, ' ');
  std::string text;
  for (const auto& [key, element] : value.items()) {
    const std::string start = margin + (value.is_object() ? scalar(key) + ": " : "");
    text += (text.empty() ? "\n" : ",\n") + start + laid_out(element, indent + 2, start.size());
  }
  text += "\n" + std::string(indent, ' ');
  return value.is_object() ? "{" + text + "}" : "[" + text + "]";
}

bool is_whole_number(const std::string& text) {
  const bool digits = std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
  return digits && !text.empty() && text.size() < 16 && (text == "0" || text.front() != '0');
}

}  // namespace

Json json_value(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    const bool whole = std::trunc(*real) == *real && std::abs(*real) < 0x1.0p53;
    return whole ? Json(static_cast<std::int64_t>(*real)) : Json(*real);
  }
  if (const auto* text = std::get_if<std::string>(&value)) return Json(*text);
  if (const auto* flag = std::get_if<bool>(&value)) return Json(*flag);
  if (const auto* curve = std::get_if<PiecewiseLinear>(&value)) {
    Json vertices = Json::array();
    for (const CurvePoint& vertex : curve->vertices) {
      vertices.push_back(Json::array({json_value(vertex.x), json_value(vertex.y)}));
    }
    return vertices;
  }
  if (const auto* bezier = std::get_if<BezierCurve>(&value)) {
    return json_value(PiecewiseLinear{{bezier->first, bezier->second}});
  }
  if (const auto* list = std::get_if<RowList>(&value)) {
    Json rows = Json::array();
    for (const ParameterValues& row : list->rows) rows.push_back(row_json(row));
    return rows;
  }
  return Json(std::get<std::int64_t>(value));
}

Json row_json(const ParameterValues& row) {
  Json json = Json::object();
  for (const Parameter& column : row.declared()) {
    if (row.is_set(column.key)) json[column.key] = json_value(column, row.value(column.key));
  }
  return json;
}

Json json_value(const Parameter& parameter, const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  const bool number = text != nullptr && parameter.kind() == ParameterKind::choice && is_whole_number(*text);
  return number ? Json(std::stoll(*text)) : json_value(value);
}

std::string pretty_json(const Json& value) { return laid_out(value, 0, 0) + "\n"; }

}  // namespace erg::io
