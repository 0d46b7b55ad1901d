#include "core/errors.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/join.h"

namespace erg {
namespace {

std::string lines(const std::vector<Mistake>& mistakes) {
  std::vector<std::string> texts;
  for (const Mistake& mistake : mistakes) texts.push_back(mistake.text());
  return join(texts, "\n");
}

/// ASCII capitals made small.
std::string folded(std::string_view text) {
  std::string low(text);
  for (char& c : low) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return low;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[b.size()];
}

/// The only candidate that begins as `wanted` (folded) does, or that it begins with; "" where there are none or
/// several.
std::string only_with_same_start(const std::string& wanted, std::span<const std::string> candidates) {
  constexpr std::size_t shortest = 3;
  const std::string* only = nullptr;
  for (const std::string& candidate : candidates) {
    const std::string known = folded(candidate);
    if (std::min(wanted.size(), known.size()) < shortest) continue;
    if (!known.starts_with(wanted) && !wanted.starts_with(known)) continue;
    if (only != nullptr) return "";
    only = &candidate;
  }
  return only != nullptr ? *only : "";
}

}  // namespace

std::string Mistake::text() const {
  std::string line = place.empty() ? problem : place + ": " + problem;
  if (!remedy.empty()) line += "; " + remedy;
  return line;
}

InputError::InputError(std::vector<Mistake> mistakes)
    : std::runtime_error(lines(mistakes)), mistakes_(std::move(mistakes)) {}

InputError::InputError(std::string place, std::string problem, std::string remedy)
    : InputError(std::vector<Mistake>{{std::move(place), std::move(problem), std::move(remedy)}}) {}

std::string quote(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::size_t length = std::min(text.size(), longest);
  const auto continues = [&](std::size_t at) { return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80; };
  while (length < text.size() && length > 0 && continues(length)) --length;  // never cut a UTF-8 character in two
  std::string shown;
  for (const char c : text.substr(0, length)) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    shown += control ? '?' : c;
  }
  if (text.size() > length) shown += "...";
  return '"' + shown + '"';
}

std::string nearest_word(std::string_view word, std::span<const std::string> candidates) {
  const std::string wanted = folded(word);
  std::string best;
  std::size_t best_distance = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(word.size(), candidate.size()) - std::min(word.size(), candidate.size());
    if (longer >= best_distance) continue;  // so many letters differ at least; a word may be a whole file
    const std::size_t distance = edit_distance(wanted, folded(candidate));
    const bool same_case_too = distance == best_distance && candidate == word;
    if (distance < best_distance || same_case_too) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best.empty() ? only_with_same_start(wanted, candidates) : best;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  if (const std::string near = nearest_word(word, candidates); !near.empty()) return "did you mean \"" + near + "\"?";
  return "expected one of " + join(candidates, ", ");
}

}  // namespace erg
