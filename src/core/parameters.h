// Parameters declared once, as data. JSON, `--set`, `--help`, the schema, the manual's tables and the window are all
// derived from these declarations; nothing else knows a range or a default.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/errors.h"
#include "core/piecewise_linear.h"

namespace erg {

/// A parameter's value. The alternative is the parameter's kind; a choice and a path are strings.
using ParameterValue = std::variant<double, std::int64_t, bool, std::string, PiecewiseLinear>;

/// What a value may be: the alternatives of ParameterValue, whose strings are one of a list (choice) or name a file.
enum class ParameterKind { real, integer, boolean, choice, path, curve };

/// The declaration of one parameter.
struct Parameter {
  std::string key;    ///< name in JSON and on the command line, snake_case
  std::string label;  ///< name for people
  std::string unit;   ///< "" for a pure number
  ParameterKind kind = ParameterKind::real;
  ParameterValue standard;  ///< default value, of the kind's alternative
  double minimum = 0;       ///< for numbers: smallest value allowed; for curves: of y
  double maximum = 0;       ///< for numbers: largest value allowed; for curves: of y
  std::string across;       ///< for curves: what runs along x, with its unit
  double across_minimum = 0;
  double across_maximum = 0;
  std::vector<std::string> choices;
  std::string meaning;
  std::string source;  ///< paper, equation or table; "" for our own
  /// What a positive number under `minimum` is a sign of, for the message that refuses it; may be empty.
  std::string too_small;
  /// Only matters when the choice `key` (first) of the same group has one of the values (rest); empty: always.
  std::vector<std::string> only_when;
  /// Read only when the terrain is made: a change needs a new terrain. Others may change while a run goes on.
  bool at_start = false;
};

/// Makers, so that a declaration reads as one line of a table.
Parameter real_parameter(std::string key, std::string label, std::string unit, double standard, double minimum,
                         double maximum, std::string meaning, std::string source = {});
Parameter integer_parameter(std::string key, std::string label, std::string unit, std::int64_t standard,
                            std::int64_t minimum, std::int64_t maximum, std::string meaning, std::string source = {});
Parameter boolean_parameter(std::string key, std::string label, bool standard, std::string meaning,
                            std::string source = {});
Parameter choice_parameter(std::string key, std::string label, std::string standard, std::vector<std::string> choices,
                           std::string meaning, std::string source = {});
Parameter path_parameter(std::string key, std::string label, std::string meaning);
/// The same declaration with its `too_small`.
Parameter with_hint(Parameter parameter, std::string too_small);
/// The same declaration, marked as read only when the terrain is made.
Parameter at_start(Parameter parameter);
/// The same declaration with its `only_when`.
Parameter only_when(Parameter parameter, std::vector<std::string> condition);

/// Where a curve's x runs.
struct CurveRange {
  std::string across;  ///< what it is, with its unit
  double minimum = 0;
  double maximum = 1;
};
/// A function that people may redraw; `unit`, `minimum` and `maximum` are those of y.
Parameter curve_parameter(std::string key, std::string label, std::string unit, PiecewiseLinear standard,
                          CurveRange across, double minimum, double maximum, std::string meaning,
                          std::string source = {});

using Parameters = std::vector<Parameter>;

/// What is wrong with `value` for this parameter (kind or range), or nothing. An integer value serves a real parameter.
std::optional<Mistake> check_value(const Parameter& parameter, const ParameterValue& value, const std::string& place);

/// Reads a value as a person types it ("0.6", "true", "flat"); throws InputError with `place`.
ParameterValue parse_value(const Parameter& parameter, std::string_view text, const std::string& place);

/// The value as a person would type it.
std::string value_text(const ParameterValue& value);

/// "0 to 1", "flat, random" ...: what a parameter accepts, for help and error messages.
std::string accepted_text(const Parameter& parameter);
/// The same with the unit, where there is one: "0.001 to 1000 m".
std::string accepted_with_unit(const Parameter& parameter);

/// One value for each declared parameter, starting at the defaults.
class ParameterValues {
 public:
  ParameterValues() = default;
  explicit ParameterValues(Parameters declared);

  const Parameters& declared() const { return declared_; }
  /// The declaration with this key, or nullptr.
  const Parameter* find(std::string_view key) const;

  /// Sets one value; throws InputError for an unknown key, a wrong kind or a value out of range.
  void set(std::string_view key, ParameterValue value);
  /// The value of any kind. As all that ask for one: throws std::logic_error for a key that is not declared, which is a
  /// bug, as it is to ask for another kind than the parameter's.
  const ParameterValue& value(std::string_view key) const;
  /// Whether the value is the declared default.
  bool is_default(std::string_view key) const;
  /// Whether the value was set, be it to the default; values compare equal all the same.
  bool is_set(std::string_view key) const;
  /// Back to the declared default, as if it had never been set.
  void reset(std::string_view key);

  /// The value of a parameter of this kind.
  double real(std::string_view key) const;
  /// An integer, or a choice between whole numbers ("4" or "8").
  std::int64_t integer(std::string_view key) const;
  bool boolean(std::string_view key) const;
  const std::string& text(std::string_view key) const;
  const PiecewiseLinear& curve(std::string_view key) const;

  /// Whether a parameter of these values matters: what its `only_when` asks for holds.
  bool matters(const Parameter& parameter) const;

  bool operator==(const ParameterValues& other) const { return values_ == other.values_; }

 private:
  std::size_t position(std::string_view key) const;  // throws std::logic_error: asking for an undeclared key is a bug

  Parameters declared_;
  std::vector<ParameterValue> values_;
  std::vector<bool> set_;
};

/// The path parameter that matters, or nullptr.
const Parameter* wanted_path(const ParameterValues& values);

}  // namespace erg
