#include "core/parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/join.h"
#include "core/number_text.h"

namespace erg {
namespace {

/// Whole numbers up to here are exact as double, and in every JSON reader.
constexpr std::int64_t largest_whole = std::int64_t{1} << 53;

/// Not the largest itself, which as a double may have been the number after it.
bool is_whole(double number) {
  return std::trunc(number) == number && std::abs(number) < static_cast<double>(largest_whole);
}

/// The value as the parameter keeps it. Call after `check_value`.
ParameterValue stored(const Parameter& parameter, ParameterValue value) {
  if (parameter.kind == ParameterKind::real) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    const double number = whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value);
    return number + 0.0;  // turns -0 into 0, which JSON readers do not tell apart
  }
  if (parameter.kind == ParameterKind::integer) {
    if (const auto* number = std::get_if<double>(&value)) return static_cast<std::int64_t>(*number);
  }
  return value;
}

std::string shown(const ParameterValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  const auto* curve = std::get_if<PiecewiseLinear>(&value);
  if (curve != nullptr && curve->vertices.size() > most_vertices) {
    return std::to_string(curve->vertices.size()) + " vertices";
  }
  return text != nullptr ? quote(*text) : value_text(value);
}

Mistake unacceptable(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  return {place, parameter.key + " is " + shown(value), "expected " + accepted_with_unit(parameter)};
}

std::optional<Mistake> check_number(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  const auto* whole = std::get_if<std::int64_t>(&value);
  const auto* real = std::get_if<double>(&value);
  if (whole == nullptr && real == nullptr) return unacceptable(parameter, value, place);
  const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
  // Beyond these a whole number may lie next to a limit and become it as a double.
  const bool exact = whole == nullptr || parameter.kind == ParameterKind::real ||
                     (*whole >= -largest_whole && *whole <= largest_whole);
  const bool kind_fits = parameter.kind == ParameterKind::real || whole != nullptr || is_whole(number);
  // Written so that NaN, which is neither below nor above anything, is refused.
  const bool range_fits = exact && number >= parameter.minimum && number <= parameter.maximum;
  if (kind_fits && range_fits) return std::nullopt;
  Mistake mistake = unacceptable(parameter, value, place);
  if (number > 0 && number < parameter.minimum && !parameter.too_small.empty()) {
    mistake.remedy += "; " + parameter.too_small;
  }
  return mistake;
}

std::optional<Mistake> check_choice(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) return unacceptable(parameter, value, place);
  if (std::ranges::find(parameter.choices, *text) != parameter.choices.end()) return std::nullopt;
  return Mistake{place, "unknown " + parameter.key + " " + quote(*text), suggestion(*text, parameter.choices)};
}

std::optional<Mistake> check_curve(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  const auto* curve = std::get_if<PiecewiseLinear>(&value);
  if (curve == nullptr) return unacceptable(parameter, value, place);
  const std::vector<CurvePoint>& vertices = curve->vertices;
  if (vertices.size() < 2 || vertices.size() > most_vertices) return unacceptable(parameter, value, place);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const auto [x, y] = vertices[k];
    // Written so that NaN is refused.
    const bool fits = x >= parameter.across_minimum && x <= parameter.across_maximum && y >= parameter.minimum &&
                      y <= parameter.maximum;
    if (!fits || (k > 0 && !(x > vertices[k - 1].x))) return unacceptable(parameter, value, place);
  }
  return std::nullopt;
}

}  // namespace

Parameter real_parameter(std::string key, std::string label, std::string unit, double standard, double minimum,
                         double maximum, std::string meaning, std::string source) {
  Parameter parameter;
  parameter.key = std::move(key);
  parameter.label = std::move(label);
  parameter.unit = std::move(unit);
  parameter.kind = ParameterKind::real;
  parameter.standard = standard;
  parameter.minimum = minimum;
  parameter.maximum = maximum;
  parameter.meaning = std::move(meaning);
  parameter.source = std::move(source);
  return parameter;
}

Parameter integer_parameter(std::string key, std::string label, std::string unit, std::int64_t standard,
                            std::int64_t minimum, std::int64_t maximum, std::string meaning, std::string source) {
  Parameter parameter =
      real_parameter(std::move(key), std::move(label), std::move(unit), 0, static_cast<double>(minimum),
                     static_cast<double>(maximum), std::move(meaning), std::move(source));
  parameter.kind = ParameterKind::integer;
  parameter.standard = standard;
  return parameter;
}

Parameter boolean_parameter(std::string key, std::string label, bool standard, std::string meaning,
                            std::string source) {
  Parameter parameter =
      real_parameter(std::move(key), std::move(label), "", 0, 0, 0, std::move(meaning), std::move(source));
  parameter.kind = ParameterKind::boolean;
  parameter.standard = standard;
  return parameter;
}

Parameter choice_parameter(std::string key, std::string label, std::string standard, std::vector<std::string> choices,
                           std::string meaning, std::string source) {
  Parameter parameter =
      real_parameter(std::move(key), std::move(label), "", 0, 0, 0, std::move(meaning), std::move(source));
  parameter.kind = ParameterKind::choice;
  parameter.standard = std::move(standard);
  parameter.choices = std::move(choices);
  return parameter;
}

Parameter path_parameter(std::string key, std::string label, std::string meaning) {
  Parameter parameter = real_parameter(std::move(key), std::move(label), "", 0, 0, 0, std::move(meaning), "");
  parameter.kind = ParameterKind::path;
  parameter.standard = std::string();
  return parameter;
}

Parameter curve_parameter(std::string key, std::string label, std::string unit, PiecewiseLinear standard,
                          CurveRange across, double minimum, double maximum, std::string meaning, std::string source) {
  Parameter parameter = real_parameter(std::move(key), std::move(label), std::move(unit), 0, minimum, maximum,
                                       std::move(meaning), std::move(source));
  parameter.kind = ParameterKind::curve;
  parameter.standard = std::move(standard);
  parameter.across = std::move(across.across);
  parameter.across_minimum = across.minimum;
  parameter.across_maximum = across.maximum;
  return parameter;
}

Parameter with_hint(Parameter parameter, std::string too_small) {
  parameter.too_small = std::move(too_small);
  return parameter;
}

Parameter at_start(Parameter parameter) {
  parameter.at_start = true;
  return parameter;
}

Parameter only_when(Parameter parameter, std::vector<std::string> condition) {
  parameter.only_when = std::move(condition);
  return parameter;
}

std::optional<Mistake> check_value(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  switch (parameter.kind) {
    case ParameterKind::real:
    case ParameterKind::integer:
      return check_number(parameter, value, place);
    case ParameterKind::choice:
      return check_choice(parameter, value, place);
    case ParameterKind::boolean:
      if (std::holds_alternative<bool>(value)) return std::nullopt;
      break;
    case ParameterKind::path:
      if (std::holds_alternative<std::string>(value)) return std::nullopt;
      break;
    case ParameterKind::curve:
      return check_curve(parameter, value, place);
  }
  return unacceptable(parameter, value, place);
}

ParameterValue parse_value(const Parameter& parameter, std::string_view text, const std::string& place) {
  ParameterValue value = std::string(text);
  if (parameter.kind == ParameterKind::real || parameter.kind == ParameterKind::integer) {
    if (const auto whole = number_from<std::int64_t>(text)) {
      value = *whole;
    } else if (const auto real = number_from<double>(text)) {
      value = *real;
    }
  } else if (parameter.kind == ParameterKind::boolean) {
    constexpr std::array<std::string_view, 3> yes{"true", "yes", "on"};
    constexpr std::array<std::string_view, 3> no{"false", "no", "off"};
    if (std::ranges::find(yes, text) != yes.end()) value = true;
    if (std::ranges::find(no, text) != no.end()) value = false;
  } else if (parameter.kind == ParameterKind::curve) {
    if (auto curve = parse_vertices(text)) value = std::move(*curve);
  }
  if (auto mistake = check_value(parameter, value, place)) throw InputError({std::move(*mistake)});
  return stored(parameter, std::move(value));
}

std::string value_text(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_shortest(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* curve = std::get_if<PiecewiseLinear>(&value)) return vertices_text(*curve);
  return std::get<std::string>(value);
}

std::string accepted_text(const Parameter& parameter) {
  const std::string range = value_text(parameter.minimum) + " to " + value_text(parameter.maximum);
  switch (parameter.kind) {
    case ParameterKind::real:
      return range;
    case ParameterKind::integer:
      return "a whole number, " + value_text(static_cast<std::int64_t>(parameter.minimum)) + " to " +
             value_text(static_cast<std::int64_t>(parameter.maximum));
    case ParameterKind::boolean:
      return "true or false";
    case ParameterKind::path:
      return "the path of a file";
    case ParameterKind::curve:
      return "2 to " + std::to_string(most_vertices) + " vertices x:y, x growing (" + parameter.across + ", " +
             value_text(parameter.across_minimum) + " to " + value_text(parameter.across_maximum) + "), y " + range;
    case ParameterKind::choice:
      break;
  }
  return join(parameter.choices, ", ");
}

std::string accepted_with_unit(const Parameter& parameter) {
  return accepted_text(parameter) + (parameter.unit.empty() ? "" : " " + unit_text(parameter.unit));
}

ParameterValues::ParameterValues(Parameters declared) : declared_(std::move(declared)) {
  values_.reserve(declared_.size());
  for (const Parameter& parameter : declared_) values_.push_back(parameter.standard);
  set_.resize(values_.size());
}

const Parameter* ParameterValues::find(std::string_view key) const {
  const auto found = std::ranges::find(declared_, key, &Parameter::key);
  return found == declared_.end() ? nullptr : &*found;
}

void ParameterValues::set(std::string_view key, ParameterValue value) {
  const Parameter* parameter = find(key);
  if (parameter == nullptr) {
    std::vector<std::string> keys;
    for (const Parameter& known : declared_) keys.push_back(known.key);
    throw InputError("", "unknown key " + quote(key), suggestion(key, keys));
  }
  if (auto mistake = check_value(*parameter, value, "")) throw InputError({std::move(*mistake)});
  values_[position(key)] = stored(*parameter, std::move(value));
  set_[position(key)] = true;
}

const ParameterValue& ParameterValues::value(std::string_view key) const { return values_[position(key)]; }

bool ParameterValues::is_default(std::string_view key) const { return value(key) == declared_[position(key)].standard; }

bool ParameterValues::is_set(std::string_view key) const { return set_[position(key)]; }

void ParameterValues::reset(std::string_view key) {
  const std::size_t place = position(key);
  values_[place] = declared_[place].standard;
  set_[place] = false;
}

double ParameterValues::real(std::string_view key) const { return std::get<double>(value(key)); }

std::int64_t ParameterValues::integer(std::string_view key) const {
  const ParameterValue& held = value(key);
  const auto* choice = std::get_if<std::string>(&held);
  if (choice == nullptr) return std::get<std::int64_t>(held);
  const auto whole = number_from<std::int64_t>(*choice);
  if (!whole) throw std::logic_error("not a whole number: parameter " + std::string(key));
  return *whole;
}

bool ParameterValues::boolean(std::string_view key) const { return std::get<bool>(value(key)); }

const std::string& ParameterValues::text(std::string_view key) const { return std::get<std::string>(value(key)); }

const PiecewiseLinear& ParameterValues::curve(std::string_view key) const {
  return std::get<PiecewiseLinear>(value(key));
}

bool ParameterValues::matters(const Parameter& parameter) const {
  const std::vector<std::string>& condition = parameter.only_when;
  if (condition.empty()) return true;
  const std::string now = value_text(value(condition.front()));
  return std::find(condition.begin() + 1, condition.end(), now) != condition.end();
}

const Parameter* wanted_path(const ParameterValues& values) {
  for (const Parameter& parameter : values.declared()) {
    if (parameter.kind == ParameterKind::path && values.matters(parameter)) return &parameter;
  }
  return nullptr;
}

std::size_t ParameterValues::position(std::string_view key) const {
  const Parameter* parameter = find(key);
  if (parameter == nullptr) throw std::logic_error("undeclared parameter " + std::string(key));
  return static_cast<std::size_t>(parameter - declared_.data());
}

}  // namespace erg
