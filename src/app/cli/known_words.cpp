#include "app/cli/known_words.h"

#include <algorithm>

#include "core/errors.h"
#include "core/join.h"

namespace erg::app {

CLI::Validator one_of(const std::vector<std::string>& words) {
  const auto check = [words](std::string& word) -> std::string {
    if (std::ranges::find(words, word) != words.end()) return "";
    return quote(word) + " is none of these; " + suggestion(word, words);
  };
  return {check, "{" + join(words, ",") + "}", "one of a few words"};
}

}  // namespace erg::app
