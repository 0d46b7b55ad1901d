// Errors that a user caused, in one form: where, what is wrong, what would be right.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace erg {

/// One mistake in what the user gave: `place: problem; remedy`.
struct Mistake {
  std::string place;    ///< file:line, key path or option; may be empty
  std::string problem;  ///< what is wrong
  std::string remedy;   ///< what would be right; may be empty

  /// `place: problem; remedy`, without the parts that are empty.
  std::string text() const;
};

/// Bad input: a config, an option, a file. Carries every mistake found, not only the first.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<Mistake> mistakes);
  InputError(std::string place, std::string problem, std::string remedy = {});

  /// All of them, in the order in which they were found.
  const std::vector<Mistake>& mistakes() const { return mistakes_; }

 private:
  std::vector<Mistake> mistakes_;
};

/// The text in double quotes for a message: on one line, cut after 60 bytes.
std::string quote(std::string_view text);

/// The candidate that `word` most likely meant, or "": edit distance at most a third of its length, at least 2, where
/// capital and small letters are the same; else the only candidate that begins as the word does or that the word begins
/// with (three letters at least).
std::string nearest_word(std::string_view word, std::span<const std::string> candidates);

/// `did you mean "x"?` when a near candidate exists, else `expected one of a, b, c`.
std::string suggestion(std::string_view word, std::span<const std::string> candidates);

}  // namespace erg
