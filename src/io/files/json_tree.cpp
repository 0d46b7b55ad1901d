#include "io/files/json_tree.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/parameters.h"

namespace erg::io {
namespace {

using nlohmann::json;

/// Deeper nesting than any config has; it bounds the recursion over the tree.
constexpr std::size_t deepest_nesting = 64;

/// Where the parser is. It reads one character past a number, so the line counted is that of the last character that is
/// no white space: a token never spans lines, hence this is the line of the token that was read last.
struct Position {
  int line = 1;
  int token_line = 1;

  void pass(char c) {
    if (c == '\n') ++line;
    if (c != '\n' && c != ' ' && c != '\t' && c != '\r') token_line = line;
  }
};

/// An input iterator over text that keeps count of lines.
class CountingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  CountingIterator(const char* at, Position* position) : at_(at), position_(position) {}
  reference operator*() const { return *at_; }
  CountingIterator& operator++() {
    position_->pass(*at_++);
    return *this;
  }
  CountingIterator operator++(int) {
    CountingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const CountingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const CountingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  Position* position_;
};

/// Builds the tree from the parser's events.
class TreeBuilder : public nlohmann::json_sax<json> {
 public:
  TreeBuilder(const std::string& name, std::string_view text, const Position& position)
      : name_(name), text_(text), position_(position) {}

  JsonTree take() { return std::move(tree_); }

  bool null() override { return add({}); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(value); }
  bool number_unsigned(number_unsigned_t value) override {
    constexpr auto largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (value > largest) return add(static_cast<double>(value));
    return add(static_cast<std::int64_t>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }  // JSON text has none

  bool start_object(std::size_t) override { return open(JsonNode::Object{}); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(JsonNode::Array{}); }
  bool end_array() override { return close(); }
  bool key(string_t& key) override {
    auto& members = std::get<JsonNode::Object>(open_.back()->value);
    members.push_back({std::move(key), position_.token_line, {}});
    key_waits_ = true;
    return true;
  }

  bool parse_error(std::size_t bytes_read, const std::string&, const json::exception& error) override {
    tree_.broken = syntax_mistake(bytes_read, error.what());
    if (key_waits_) std::get<JsonNode::Object>(open_.back()->value).pop_back();  // its value never came
    return false;
  }

 private:
  using Value = decltype(JsonNode::value);

  /// Puts a value where the next one belongs: the root, the last key's value, or the end of the array.
  JsonNode& place() {
    key_waits_ = false;
    if (open_.empty()) return tree_.root;
    if (auto* array = std::get_if<JsonNode::Array>(&open_.back()->value)) return array->emplace_back();
    return std::get<JsonNode::Object>(open_.back()->value).back().node;
  }

  JsonNode& put(Value value) {
    JsonNode& node = place();
    node.line = position_.token_line;
    node.value = std::move(value);
    return node;
  }

  bool add(Value value) {
    put(std::move(value));
    return true;
  }

  bool open(Value value) {
    if (open_.size() == deepest_nesting) {
      tree_.broken = Mistake{name_ + ":" + std::to_string(position_.token_line),
                             "lists and objects stand too deep inside each other", "a config needs only a few levels"};
      return false;
    }
    // A parent's list does not grow while a child is open, so the pointers stay good.
    open_.push_back(&put(std::move(value)));
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  Mistake syntax_mistake(std::size_t bytes_read, std::string message) const;

  std::string name_;
  std::string_view text_;
  const Position& position_;
  JsonTree tree_;
  std::vector<JsonNode*> open_;
  bool key_waits_ = false;  ///< the last event was a key
};

/// Cuts `text` at the first `mark`; returns what follows it.
std::string cut_at(std::string& text, std::string_view mark) {
  const std::size_t at = text.find(mark);
  if (at == std::string::npos) return {};
  std::string rest = text.substr(at + mark.size());
  text.erase(at);
  return rest;
}

/// The parser says `[json.exception...] parse error at line 3, column 5: syntax error while parsing object - unexpected
/// '}'; last read: '}'; expected string literal`.
Mistake TreeBuilder::syntax_mistake(std::size_t bytes_read, std::string message) const {
  const std::size_t at = bytes_read == 0 ? 0 : std::min(bytes_read - 1, text_.size());
  const std::string_view before = text_.substr(0, at);
  const auto line = 1 + std::ranges::count(before, '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  const std::string place = name_ + ":" + std::to_string(line) + ":" + std::to_string(at - line_start + 1);

  if (const std::size_t number = message.find("number overflow parsing "); number != std::string::npos) {
    std::string literal = message.substr(number + std::string_view("number overflow parsing ").size());
    std::erase(literal, '\'');
    return {place, "the number " + quote(literal) + " is too large", "write a number that a config accepts"};
  }
  std::string expected = cut_at(message, "; expected ");
  cut_at(message, "; last read: ");
  const std::string detail = cut_at(message, " - ");
  std::string problem = "syntax error: " + (detail.empty() ? std::string("this is not JSON") : detail);
  const std::size_t last_mark = before.find_last_not_of(" \t\r\n");
  const bool comma_before_end = last_mark != std::string_view::npos && before[last_mark] == ',' && at < text_.size() &&
                                (text_[at] == '}' || text_[at] == ']');
  if (at < text_.size() && text_[at] == '#') {
    return {place, std::move(problem), "a comment begins with //, or stands between /* and */"};
  }
  if (comma_before_end) return {place, std::move(problem), "remove the comma before it"};
  return {place, std::move(problem), expected.empty() ? "" : "expected " + expected};
}

/// Whether a comment stands anywhere outside of strings.
bool has_comments(std::string_view text) {
  bool in_string = false;
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    if (in_string && text[at] == '\\') {
      ++at;
    } else if (text[at] == '"') {
      in_string = !in_string;
    } else if (!in_string && text[at] == '/' && (text[at + 1] == '/' || text[at + 1] == '*')) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::optional<double> JsonNode::number() const {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

std::string JsonNode::shown() const {
  if (array() != nullptr) return "a list";
  if (object() != nullptr) return "an object";
  if (const std::string* string = text()) return quote(*string);
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return value_text(*whole);
  if (const auto* real = std::get_if<double>(&value)) return value_text(*real);
  return "null";
}

JsonTree read_json(std::string_view text, const std::string& name) {
  Position position;
  TreeBuilder builder(name, text, position);
  const CountingIterator first(text.data(), &position);
  const CountingIterator last(text.data() + text.size(), &position);
  constexpr bool to_the_end = true;
  constexpr bool over_comments = true;
  json::sax_parse(first, last, &builder, json::input_format_t::json, to_the_end, over_comments);
  JsonTree tree = builder.take();
  tree.has_comments = has_comments(text);
  return tree;
}

}  // namespace erg::io
