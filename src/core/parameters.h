// Parameters declared once, as data. JSON, `--set`, `--help`, the schema, the manual's tables and the window are all
// derived from these declarations; nothing else knows a range or a default.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/bezier.h"
#include "core/errors.h"
#include "core/piecewise_linear.h"

namespace erg {

class ParameterValues;
struct Parameter;
using Parameters = std::vector<Parameter>;

/// A list of rows, each of them the values of the same declared columns.
struct RowList {
  std::vector<ParameterValues> rows;

  // Where ParameterValues, which a value may hold in turn, is complete.
  RowList();
  explicit RowList(std::vector<ParameterValues> given);
  RowList(const RowList& other);
  RowList(RowList&& other) noexcept;
  RowList& operator=(const RowList& other);
  RowList& operator=(RowList&& other) noexcept;
  ~RowList();
  bool operator==(const RowList& other) const;
};

/// A parameter's value. The alternative is the parameter's kind; a choice and a path are strings.
using ParameterValue = std::variant<double, std::int64_t, bool, std::string, PiecewiseLinear, BezierCurve, RowList>;

/// What a value may be: the alternatives of ParameterValue, whose strings are one of a list (choice) or name a file.
enum class ParameterKind { real, integer, boolean, choice, path, curve, bezier, rows };

/// Another way in which people write a number: a bearing as a point of the compass.
struct Notation {
  const char* accepted = "";  ///< what is accepted, numbers too, for messages
  /// Reads either; throws InputError with `place`.
  double (*parse)(std::string_view text, const std::string& place) = nullptr;
  /// The one number that is kept for all that mean the same.
  double (*fold)(double number) = nullptr;
};

/// A table of declarations that never changes: made once, and shared by all values that stand under it.
class Declarations {
 public:
  Declarations();
  Declarations(Parameters parameters);
  Declarations(std::initializer_list<Parameter> parameters);

  operator const Parameters&() const { return *parameters_; }
  const Parameters& all() const { return *parameters_; }
  const Parameter* begin() const;
  const Parameter* end() const;
  /// The declaration with this key, or nullptr.
  const Parameter* find(std::string_view key) const;

 private:
  std::shared_ptr<const Parameters> parameters_;
};

/// The declaration of one parameter, written with its members' names: what is left out is empty, or has no limit.
///
///   Parameter{.key = "p_sand", .label = "Deposition on sand", .default_value = 0.6, .minimum = 0, .maximum = 1, ...}
struct Parameter {
  std::string key = {};    ///< name in JSON and on the command line, snake_case
  std::string label = {};  ///< name for people
  std::string unit = {};   ///< "" for a pure number
  /// Its alternative is the parameter's kind: 1.0 is a real number, 1 a whole one.
  ParameterValue default_value = 0.0;
  double minimum = 0;                     ///< for numbers: smallest value allowed; for curves: of y; for rows: fewest
  double maximum = 0;                     ///< for numbers: largest value allowed; for curves: of y; for rows: most
  std::vector<std::string> choices = {};  ///< what a text may be; none: it is the path of a file
  std::string x_label = {};               ///< for curves: what runs along x, with its unit
  double x_minimum = 0;
  double x_maximum = 1;
  Declarations columns = {};           ///< for rows
  std::string row_name = {};           ///< for rows: what people call one, "season"
  const Notation* notation = nullptr;  ///< for real numbers: how else people write them; null: not
  std::string meaning = {};
  std::string source = {};  ///< paper, equation or table; "" for our own
  /// What a positive number under `minimum` is a sign of, for the message that refuses it; may be empty.
  std::string too_small = {};
  /// Has an effect only when the choice `key` (first) of the same group has one of the values (rest); empty: always.
  std::vector<std::string> active_if = {};
  /// Read only when the terrain is made: a change needs a new terrain. Others may change while a run goes on.
  bool at_start = false;

  ParameterKind kind() const;
};

/// What is wrong with `value` for this parameter (kind or range), or nothing. An integer value serves a real parameter.
std::optional<Mistake> check_value(const Parameter& parameter, const ParameterValue& value, const std::string& place);

/// Reads a value as a person types it ("0.6", "true", "flat"); throws InputError with `place`.
ParameterValue parse_value(const Parameter& parameter, std::string_view text, const std::string& place);

/// The value as a person would type it; rows as [key=value, ...].
std::string value_text(const ParameterValue& value);

/// "0 to 1", "flat, random" ...: what a parameter accepts, for help and error messages.
std::string accepted_text(const Parameter& parameter);
/// The same with the unit, where there is one: "0.001 to 1000 m".
std::string accepted_with_unit(const Parameter& parameter);

/// One value for each declared parameter, starting at the defaults.
class ParameterValues {
 public:
  ParameterValues() = default;
  explicit ParameterValues(Declarations declared);

  const Parameters& declared() const { return declared_.all(); }
  /// The same, to be shared with other values.
  const Declarations& declarations() const { return declared_; }
  /// The declaration with this key, or nullptr.
  const Parameter* find(std::string_view key) const { return declared_.find(key); }

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
  const BezierCurve& bezier(std::string_view key) const;
  const std::vector<ParameterValues>& rows(std::string_view key) const;

  /// Whether a parameter has an effect with these values: what its `active_if` asks for holds.
  bool is_active(const Parameter& parameter) const;

  bool operator==(const ParameterValues& other) const { return values_ == other.values_; }

 private:
  std::size_t position(std::string_view key) const;  // throws std::logic_error: asking for an undeclared key is a bug

  Declarations declared_;
  std::vector<ParameterValue> values_;
  std::vector<bool> set_;
};

/// The active path parameter, or nullptr.
const Parameter* wanted_path(const ParameterValues& values);

}  // namespace erg
