// JSON as people like to read it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/parameters.h"

namespace erg::io {

/// A value as JSON, whole numbers without a point.
nlohmann::ordered_json json_value(const ParameterValue& value);
/// The same for a parameter: a choice between numbers ("4" or "8") becomes a number.
nlohmann::ordered_json json_value(const Parameter& parameter, const ParameterValue& value);

/// The values of a row that were set, as an object.
nlohmann::ordered_json row_json(const ParameterValues& row);

/// The text with two spaces of indentation, but with lists and objects that fit on a line kept on one. Ends in a
/// newline. Text that is not UTF-8 comes out with replacement characters.
std::string pretty_json(const nlohmann::ordered_json& value);

}  // namespace erg::io
