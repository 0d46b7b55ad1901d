// A JSON text as a tree in which every value knows its line, so that mistakes can be reported where they stand.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/errors.h"

namespace erg::io {

struct JsonMember;

/// One JSON value.
struct JsonNode {
  using Array = std::vector<JsonNode>;
  using Object = std::vector<JsonMember>;  ///< in the order of the text; a key may stand twice

  int line = 1;
  std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object> value;

  const Array* array() const { return std::get_if<Array>(&value); }
  const Object* object() const { return std::get_if<Object>(&value); }
  const std::string* text() const { return std::get_if<std::string>(&value); }
  /// A number of either kind.
  std::optional<double> number() const;
  /// The value for a message: `3`, `"flat"`, `a list`, `an object`, `null`.
  std::string shown() const;
};

/// A key with its value; `line` is the key's.
struct JsonMember {
  std::string key;
  int line = 1;
  JsonNode node;
};

/// What a text holds. With a syntax error, `root` holds what stands before it and `broken` is set.
struct JsonTree {
  JsonNode root;
  std::optional<Mistake> broken;  ///< place is name:line:column
  bool has_comments = false;
};

/// Reads any text whatever, passing over comments (`// ...` and `/* ... */`); `name` stands in the places of mistakes.
JsonTree read_json(std::string_view text, const std::string& name);

}  // namespace erg::io
