#include "io/files/text_encoding.h"

#include <array>
#include <cstdio>
#include <string_view>

#include "core/errors.h"

namespace erg::io {
namespace {

using namespace std::string_view_literals;

struct Encoding {
  std::string_view start;
  const char* name;
};

/// Marks, longest first, for one begins as another does.
constexpr std::array marks{Encoding{"\xff\xfe\0\0"sv, "UTF-32"}, Encoding{"\0\0\xfe\xff"sv, "UTF-32"},
                           Encoding{"\xff\xfe"sv, "UTF-16"}, Encoding{"\xfe\xff"sv, "UTF-16"}};

/// By where zero bytes stand: texts begin with a letter or a bracket of ASCII, which has them before or behind it.
const char* encoding_without_mark(std::string_view text) {
  if (text.size() < 4) return nullptr;
  const auto zero = [&](std::size_t at) { return text[at] == '\0'; };
  if (zero(1) && zero(2) && zero(3) && !zero(0)) return "UTF-32LE";
  if (zero(0) && zero(1) && zero(2) && !zero(3)) return "UTF-32BE";
  if (zero(1) && zero(3) && !zero(0) && !zero(2)) return "UTF-16LE";
  if (zero(0) && zero(2) && !zero(1) && !zero(3)) return "UTF-16BE";
  return nullptr;
}

/// Bytes of the UTF-8 character at the start of a text; 0 where there is none.
std::size_t character_bytes(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t at = 1; at < length; ++at) {
    if ((byte(at) & 0xc0) != 0x80) return 0;
  }
  // Too long for their number, halves of UTF-16 pairs, and numbers that no character has.
  const bool refused = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) ||
                       (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f);
  return refused ? 0 : length;
}

[[noreturn]] void refuse(const std::string& place, const std::string& problem, const std::string& from) {
  throw InputError(place, problem, "save it as UTF-8, or convert it: iconv -f " + from + " -t UTF-8 IN > OUT");
}

void check_utf8(std::string_view text, const std::string& place) {
  int line = 1;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_bytes(text.substr(at));
    if (length == 0) {
      char byte[8];
      std::snprintf(byte, sizeof byte, "0x%02X", static_cast<unsigned char>(text[at]));
      refuse(place + ":" + std::to_string(line),
             std::string("this text is not UTF-8 (byte ") + byte + "); it looks like Latin-1 or Windows-1252",
             "WINDOWS-1252");
    }
    if (text[at] == '\n') ++line;
    at += length;
  }
}

}  // namespace

std::string utf8_text(std::string text, const std::string& place) {
  for (const Encoding& mark : marks) {
    if (text.starts_with(mark.start))
      refuse(place, std::string("this text is ") + mark.name + ", not UTF-8", mark.name);
  }
  if (const char* name = encoding_without_mark(text)) {
    refuse(place, std::string("this text is ") + name + ", not UTF-8", name);
  }
  if (text.starts_with("\xef\xbb\xbf")) text.erase(0, 3);
  check_utf8(text, place);
  return text;
}

}  // namespace erg::io
