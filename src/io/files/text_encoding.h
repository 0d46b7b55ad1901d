// How texts that people give are encoded: all that this program reads is UTF-8.
#pragma once

#include <string>

namespace erg::io {

/// The text without a mark of UTF-8 (BOM) before it. Throws InputError, with `place` (the file's name), where it is not
/// UTF-8: says what it most likely is (UTF-16 and UTF-32 with and without a mark, Latin-1), where, and what converts
/// it.
std::string utf8_text(std::string text, const std::string& place);

}  // namespace erg::io
