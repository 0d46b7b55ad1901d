#include "core/join.h"

namespace erg {

std::string join(std::span<const std::string> words, std::string_view between) {
  std::string all;
  for (const std::string& word : words) {
    if (&word != words.data()) all += between;
    all += word;
  }
  return all;
}

}  // namespace erg
