#include "ui/window/key_place.h"

#include <X11/keysym.h>

#include <array>
#include <string_view>
#include <utility>

#include "ui/widgets/gui.h"

namespace erg::ui {
namespace {

using Symbol = unsigned long;

bool is_ascii(Symbol symbol) { return symbol >= 0x20 && symbol < 0x7f; }
bool is_digit(Symbol symbol) { return symbol >= '0' && symbol <= '9'; }
bool is_letter(Symbol symbol) { return (symbol >= 'a' && symbol <= 'z') || (symbol >= 'A' && symbol <= 'Z'); }

int capital(Symbol symbol) {
  const int letter = static_cast<int>(symbol);
  return letter >= 'a' && letter <= 'z' ? letter - 'a' + 'A' : letter;
}

/// Keys that write nothing, or the same everywhere.
int fixed_place(Symbol symbol) {
  constexpr std::array<std::pair<Symbol, int>, 34> places{{{XK_BackSpace, keys::backspace},
                                                           {XK_Tab, keys::tab},
                                                           {XK_ISO_Left_Tab, keys::tab},
                                                           {XK_KP_Tab, keys::tab},
                                                           {XK_Return, keys::enter},
                                                           {XK_KP_Enter, keys::enter},
                                                           {XK_Escape, keys::escape},
                                                           {XK_space, keys::space},
                                                           {XK_KP_Space, keys::space},
                                                           {XK_Delete, keys::remove},
                                                           {XK_KP_Delete, keys::remove},
                                                           {XK_Left, keys::left},
                                                           {XK_KP_Left, keys::left},
                                                           {XK_Right, keys::right},
                                                           {XK_KP_Right, keys::right},
                                                           {XK_Up, keys::up},
                                                           {XK_KP_Up, keys::up},
                                                           {XK_Down, keys::down},
                                                           {XK_KP_Down, keys::down},
                                                           {XK_Page_Up, keys::page_up},
                                                           {XK_KP_Page_Up, keys::page_up},
                                                           {XK_Page_Down, keys::page_down},
                                                           {XK_KP_Page_Down, keys::page_down},
                                                           {XK_Home, keys::home},
                                                           {XK_KP_Home, keys::home},
                                                           {XK_End, keys::end},
                                                           {XK_KP_End, keys::end},
                                                           {XK_Insert, keys::insert},
                                                           {XK_KP_Insert, keys::insert},
                                                           {XK_KP_Add, '+'},
                                                           {XK_KP_Subtract, '-'},
                                                           {XK_KP_Decimal, '.'},
                                                           {XK_KP_Separator, '.'},
                                                           {XK_period, '.'}}};
  for (const auto& [wanted, place] : places) {
    if (wanted == symbol) return place;
  }
  if (symbol >= XK_F1 && symbol <= XK_F12) return keys::function + 1 + static_cast<int>(symbol - XK_F1);
  if (symbol >= XK_KP_0 && symbol <= XK_KP_9) return '0' + static_cast<int>(symbol - XK_KP_0);
  return -1;
}

/// What lies there on an American keyboard: letters, digits, and the full stop.
int place_at(std::string_view position) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> rows{
      {{"AE", "1234567890"}, {"AD", "QWERTYUIOP"}, {"AC", "ASDFGHJKL"}, {"AB", "ZXCVBNM ."}}};
  if (position.size() != 4) return -1;
  const std::string_view keys = position.substr(2);
  if (!is_digit(static_cast<unsigned char>(keys[0])) || !is_digit(static_cast<unsigned char>(keys[1]))) return -1;
  const int number = 10 * (keys[0] - '0') + keys[1] - '0';
  for (const auto& [row, letters] : rows) {
    if (row != position.substr(0, 2) || number < 1 || number > static_cast<int>(letters.size())) continue;
    const char letter = letters[static_cast<std::size_t>(number - 1)];
    return letter == ' ' ? -1 : letter;
  }
  return -1;
}

}  // namespace

int key_place(const PressedKey& key) {
  if (const int place = fixed_place(key.symbol); place >= 0) return place;
  if (key.symbol == '+' || key.symbol == '-') return static_cast<int>(key.symbol);
  if (is_letter(key.plain)) return capital(key.plain);
  for (const Symbol symbol : {key.plain, key.shifted}) {
    if (is_digit(symbol)) return static_cast<int>(symbol);
  }
  if (is_ascii(key.plain)) return capital(key.plain);
  if (is_letter(key.latin)) return capital(key.latin);
  if (key.plain == 0 && key.symbol == 0) return -1;
  return place_at(key.position);
}

}  // namespace erg::ui
