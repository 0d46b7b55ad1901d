// Files as accidents and strangers make them: the same ones in every run. With ERG_MUTATIONS=N in the environment, N of
// each kind instead of the usual few.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <string_view>

namespace erg::test {

/// So many mutations of a kind: `usual`, unless the environment says otherwise.
inline int mutations(int usual) {
  const char* const asked = std::getenv("ERG_MUTATIONS");
  return asked == nullptr ? usual : std::atoi(asked);
}

/// Changes texts and bytes at random.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  /// `bytes` with one to four changes.
  std::string of(std::string bytes) {
    for (std::size_t change = 0, changes = 1 + below(4); change < changes; ++change) change_once(bytes);
    return bytes;
  }

 private:
  /// 0 to end - 1.
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }

  void change_once(std::string& bytes) {
    const std::size_t place = below(bytes.size());
    const std::size_t length = std::min(bytes.size() - place, 1 + below(below(3) == 0 ? 200 : 8));
    switch (below(8)) {
      case 0:
        if (!bytes.empty()) bytes[place] = static_cast<char>(bytes[place] ^ (1 << below(8)));
        break;
      case 1:
        if (!bytes.empty()) bytes[place] = static_cast<char>(random_());
        break;
      case 2:
        bytes.resize(place);
        break;
      case 3:
        bytes.erase(place, length);
        break;
      case 4:
        bytes.insert(below(bytes.size()), bytes.substr(place, length));
        break;
      case 5:
        bytes.replace(place, below(2) == 0 ? 0 : length, word());
        break;
      default:
        put_number(bytes, place);
    }
  }

  /// What JSON may hold where nobody expects it.
  std::string word() {
    constexpr std::array<std::string_view, 22> words{"{",
                                                     "}",
                                                     "[",
                                                     "]",
                                                     ",",
                                                     ":",
                                                     "\"",
                                                     "\\",
                                                     "null",
                                                     "true",
                                                     "{}",
                                                     "[[[[",
                                                     "-1",
                                                     "1e99",
                                                     "-0",
                                                     "0.",
                                                     "1e999",
                                                     "x",
                                                     "\xc3",
                                                     "\\ud800",
                                                     "99999999999999999999",
                                                     "-9223372036854775808"};
    return std::string(words[below(words.size())]);
  }

  /// Overwrites with the numbers at which arithmetic ends.
  void put_number(std::string& bytes, std::size_t place) {
    constexpr std::array<std::uint64_t, 12> numbers{0,
                                                    1,
                                                    0x7f,
                                                    0x80,
                                                    0xff,
                                                    0x7fffffff,
                                                    0x80000000,
                                                    0xffffffff,
                                                    0x7fffffffffffffff,
                                                    0x8000000000000000,
                                                    0x7ff0000000000000 /* infinity */,
                                                    0x7fc000007fc00000 /* not a number */};
    const std::uint64_t number = numbers[below(numbers.size())];
    const std::size_t size = std::size_t{1} << below(4);
    if (place + size <= bytes.size()) std::memcpy(bytes.data() + place, &number, size);
  }

  std::mt19937 random_;
};

}  // namespace erg::test
