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
  if (parameter.kind() == ParameterKind::real) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    const double number = whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value);
    if (parameter.notation != nullptr) return parameter.notation->fold(number);
    return number + 0.0;  // turns -0 into 0, which JSON readers do not tell apart
  }
  if (parameter.kind() == ParameterKind::integer) {
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
  const bool exact = whole == nullptr || parameter.kind() == ParameterKind::real ||
                     (*whole >= -largest_whole && *whole <= largest_whole);
  const bool kind_fits = parameter.kind() == ParameterKind::real || whole != nullptr || is_whole(number);
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
    const bool fits =
        x >= parameter.x_minimum && x <= parameter.x_maximum && y >= parameter.minimum && y <= parameter.maximum;
    if (!fits || (k > 0 && !(x > vertices[k - 1].x))) return unacceptable(parameter, value, place);
  }
  return std::nullopt;
}

bool in_unit_square(const CurvePoint& point) { return point.x >= 0 && point.x <= 1 && point.y >= 0 && point.y <= 1; }

std::optional<Mistake> check_bezier(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  const auto* curve = std::get_if<BezierCurve>(&value);
  if (curve != nullptr && in_unit_square(curve->first) && in_unit_square(curve->second)) return std::nullopt;
  return Mistake{place, parameter.key + " is not two points of the unit square",
                 "expected " + accepted_text(parameter)};
}

/// Each row's own values are right, since it refuses others.
std::optional<Mistake> check_rows(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  const auto* list = std::get_if<RowList>(&value);
  if (list == nullptr) return unacceptable(parameter, value, place);
  const auto count = static_cast<double>(list->rows.size());
  const bool same = std::ranges::all_of(list->rows, [&](const ParameterValues& row) {
    return std::ranges::equal(row.declared(), parameter.columns.all(), {}, &Parameter::key, &Parameter::key);
  });
  if (same && count >= parameter.minimum && count <= parameter.maximum) return std::nullopt;
  return Mistake{place, parameter.key + " has " + std::to_string(list->rows.size()) + " rows",
                 "expected " + accepted_text(parameter)};
}

std::string row_text(const ParameterValues& row) {
  std::string text;
  for (const Parameter& column : row.declared()) {
    if (!row.is_set(column.key)) continue;
    text += (text.empty() ? "" : ", ") + column.key + "=" + value_text(row.value(column.key));
  }
  return "[" + text + "]";
}

}  // namespace

RowList::RowList() = default;
RowList::RowList(std::vector<ParameterValues> given) : rows(std::move(given)) {}
RowList::RowList(const RowList& other) = default;
RowList::RowList(RowList&& other) noexcept = default;
RowList& RowList::operator=(const RowList& other) = default;
RowList& RowList::operator=(RowList&& other) noexcept = default;
RowList::~RowList() = default;
bool RowList::operator==(const RowList& other) const { return rows == other.rows; }

ParameterKind Parameter::kind() const {
  if (std::holds_alternative<double>(default_value)) return ParameterKind::real;
  if (std::holds_alternative<std::int64_t>(default_value)) return ParameterKind::integer;
  if (std::holds_alternative<bool>(default_value)) return ParameterKind::boolean;
  if (std::holds_alternative<PiecewiseLinear>(default_value)) return ParameterKind::curve;
  if (std::holds_alternative<BezierCurve>(default_value)) return ParameterKind::bezier;
  if (std::holds_alternative<RowList>(default_value)) return ParameterKind::rows;
  return choices.empty() ? ParameterKind::path : ParameterKind::choice;
}

Declarations::Declarations() {
  static const auto none = std::make_shared<const Parameters>();
  parameters_ = none;
}

Declarations::Declarations(Parameters parameters)
    : parameters_(std::make_shared<const Parameters>(std::move(parameters))) {}

Declarations::Declarations(std::initializer_list<Parameter> parameters) : Declarations(Parameters(parameters)) {}

const Parameter* Declarations::begin() const { return parameters_->data(); }

const Parameter* Declarations::end() const { return parameters_->data() + parameters_->size(); }

const Parameter* Declarations::find(std::string_view key) const {
  const auto found = std::ranges::find(*parameters_, key, &Parameter::key);
  return found == parameters_->end() ? nullptr : &*found;
}

std::optional<Mistake> check_value(const Parameter& parameter, const ParameterValue& value, const std::string& place) {
  switch (parameter.kind()) {
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
    case ParameterKind::bezier:
      return check_bezier(parameter, value, place);
    case ParameterKind::rows:
      return check_rows(parameter, value, place);
  }
  return unacceptable(parameter, value, place);
}

ParameterValue parse_value(const Parameter& parameter, std::string_view text, const std::string& place) {
  ParameterValue value = std::string(text);
  if (parameter.notation != nullptr) {
    value = parameter.notation->parse(text, place);
  } else if (parameter.kind() == ParameterKind::real || parameter.kind() == ParameterKind::integer) {
    if (const auto whole = number_from<std::int64_t>(text)) {
      value = *whole;
    } else if (const auto real = number_from<double>(text)) {
      value = *real;
    }
  } else if (parameter.kind() == ParameterKind::boolean) {
    constexpr std::array<std::string_view, 3> yes{"true", "yes", "on"};
    constexpr std::array<std::string_view, 3> no{"false", "no", "off"};
    if (std::ranges::find(yes, text) != yes.end()) value = true;
    if (std::ranges::find(no, text) != no.end()) value = false;
  } else if (parameter.kind() == ParameterKind::curve) {
    if (auto curve = parse_vertices(text)) value = std::move(*curve);
  } else if (parameter.kind() == ParameterKind::bezier) {
    const auto points = parse_vertices(text);
    if (points && points->vertices.size() == 2) value = BezierCurve{points->vertices[0], points->vertices[1]};
  }
  if (auto mistake = check_value(parameter, value, place)) throw InputError({std::move(*mistake)});
  return stored(parameter, std::move(value));
}

std::string value_text(const ParameterValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return format_shortest(*number);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* curve = std::get_if<PiecewiseLinear>(&value)) return vertices_text(*curve);
  if (const auto* bezier = std::get_if<BezierCurve>(&value)) return vertices_text({{bezier->first, bezier->second}});
  if (const auto* list = std::get_if<RowList>(&value)) {
    std::string text;
    for (const ParameterValues& row : list->rows) text += (text.empty() ? "" : " ") + row_text(row);
    return text;
  }
  return std::get<std::string>(value);
}

std::string accepted_text(const Parameter& parameter) {
  if (parameter.notation != nullptr) return parameter.notation->accepted;
  const std::string range = value_text(parameter.minimum) + " to " + value_text(parameter.maximum);
  switch (parameter.kind()) {
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
      return "2 to " + std::to_string(most_vertices) + " vertices x:y, x growing (" + parameter.x_label + ", " +
             value_text(parameter.x_minimum) + " to " + value_text(parameter.x_maximum) + "), y " + range;
    case ParameterKind::bezier:
      return "two control points, [[x, y], [x, y]], each number 0 to 1";
    case ParameterKind::rows: {
      const auto fewest = static_cast<std::int64_t>(parameter.minimum);
      return "a list of " + parameter.row_name + "s, [{ ... }, { ... }], " + std::to_string(fewest) + " to " +
             value_text(parameter.maximum) + " of them";
    }
    case ParameterKind::choice:
      break;
  }
  return join(parameter.choices, ", ");
}

std::string accepted_with_unit(const Parameter& parameter) {
  const bool has_unit = !parameter.unit.empty() && parameter.notation == nullptr;
  return accepted_text(parameter) + (has_unit ? " " + unit_text(parameter.unit) : "");
}

ParameterValues::ParameterValues(Declarations declared) : declared_(std::move(declared)) {
  values_.reserve(declared_.all().size());
  for (const Parameter& parameter : declared_) values_.push_back(parameter.default_value);
  set_.resize(values_.size());
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

bool ParameterValues::is_default(std::string_view key) const {
  return value(key) == declared()[position(key)].default_value;
}

bool ParameterValues::is_set(std::string_view key) const { return set_[position(key)]; }

void ParameterValues::reset(std::string_view key) {
  const std::size_t place = position(key);
  values_[place] = declared()[place].default_value;
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

const BezierCurve& ParameterValues::bezier(std::string_view key) const { return std::get<BezierCurve>(value(key)); }

const std::vector<ParameterValues>& ParameterValues::rows(std::string_view key) const {
  return std::get<RowList>(value(key)).rows;
}

bool ParameterValues::is_active(const Parameter& parameter) const {
  const std::vector<std::string>& condition = parameter.active_if;
  if (condition.empty()) return true;
  const std::string now = value_text(value(condition.front()));
  return std::find(condition.begin() + 1, condition.end(), now) != condition.end();
}

const Parameter* wanted_path(const ParameterValues& values) {
  for (const Parameter& parameter : values.declared()) {
    if (parameter.kind() == ParameterKind::path && values.is_active(parameter)) return &parameter;
  }
  return nullptr;
}

std::size_t ParameterValues::position(std::string_view key) const {
  const Parameter* parameter = find(key);
  if (parameter == nullptr) throw std::logic_error("undeclared parameter " + std::string(key));
  return static_cast<std::size_t>(parameter - declared().data());
}

}  // namespace erg
