// Numbers as people of every country type them.
#pragma once

#include <string>
#include <string_view>

namespace erg::ui {

/// A letter typed into an entry that takes a number, as the entry reads it: a decimal comma of any script is a decimal
/// point, a digit of any script that digit, a typographic minus a minus.
char32_t as_typed_in_number(char32_t letter);

/// To be called before an ImGui item of this id that takes a number: reads so what is typed into it in this frame.
/// ImGui would throw a decimal comma away, and 0,25 would be 25.
void take_typed_number(const char* id);

/// A number that was copied elsewhere, the same way: "0,25" is 0.25, "1.234,5" and "1,234.5" are 1234.5, spaces between
/// thousands go. What is no number stays as it is.
std::string as_pasted_number(std::string_view text);

}  // namespace erg::ui
