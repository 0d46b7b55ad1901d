#include "ui/widgets/typed_number.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/widgets/fonts.h"

namespace erg::ui {
namespace {

constexpr char32_t arabic_decimal = 0x66b;

/// First digits of scripts that people count with: Arabic, Persian, Devanagari, Bengali, Thai, full-width.
constexpr std::array<char32_t, 6> zeros{0x660, 0x6f0, 0x966, 0x9e6, 0xe50, 0xff10};

bool is_space(char32_t letter) {
  return letter == ' ' || letter == 0xa0 || letter == 0x2009 || letter == 0x202f || letter == '\'' ||
         letter == 0x2019 || letter == 0x66c;
}

}  // namespace

char32_t as_typed_in_number(char32_t letter) {
  for (const char32_t zero : zeros) {
    if (letter >= zero && letter < zero + 10) return U'0' + (letter - zero);
  }
  switch (letter) {
    case U',':
    case arabic_decimal:
    case 0xff0c:  // full-width comma
    case 0xff0e:  // full-width full stop
    case 0x3001:  // ideographic comma
    case 0x3002:  // ideographic full stop
      return U'.';
    case 0x2212:  // minus
    case 0x2013:  // dash
    case 0xff0d:  // full-width minus
      return U'-';
    default:
      return letter;
  }
}

void take_typed_number(const char* id) {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  const ImGuiID own = ImGui::GetID(id);
  if (context.ActiveId != own || context.InputTextState.ID != own) return;
  for (ImWchar& letter : ImGui::GetIO().InputQueueCharacters) {
    letter = static_cast<ImWchar>(as_typed_in_number(letter));
  }
}

std::string as_pasted_number(std::string_view text) {
  std::u32string letters;
  for (std::string_view rest = text; !rest.empty();) {
    const char32_t letter = take_letter(rest);
    if (is_space(letter)) continue;  // of thousands
    // Which of two marks is the decimal one shows when both are there, so a comma stays one for now.
    letters += letter == U',' ? letter : as_typed_in_number(letter);
  }
  const std::size_t comma = letters.rfind(U',');
  const std::size_t point = letters.rfind(U'.');
  const auto count = [&](char32_t mark) { return std::ranges::count(letters, mark); };
  if (comma != std::u32string::npos && (point != std::u32string::npos || count(U',') > 1)) {
    const bool comma_is_decimal = point != std::u32string::npos && comma > point && count(U',') == 1;
    std::erase(letters, comma_is_decimal ? U'.' : U',');
  } else if (count(U'.') > 1) {
    std::erase(letters, U'.');
  }
  std::ranges::replace(letters, U',', U'.');
  std::string number;
  for (const char32_t letter : letters) number += utf8_of(letter);
  return number;
}

}  // namespace erg::ui
