// From what an X server says of a key to its place in ImGuiIO::KeysDown, whatever the keyboard's layout. Knows the
// numbers of X's key symbols, but needs no X.
#pragma once

#include <string>

namespace erg::ui {

/// A key that was pressed. Symbols are X's keysyms; 0: there is none.
struct PressedKey {
  unsigned long symbol = 0;   ///< what it gives as it was pressed: Shift and Num Lock count
  unsigned long plain = 0;    ///< what it gives alone
  unsigned long shifted = 0;  ///< with Shift
  unsigned long latin = 0;    ///< what it gives alone in another layout that is switched to, where that is a letter
  std::string position = {};  ///< where it lies: "AD01" is right of Tab, as XKB names it
};

/// The place of a key (ui/widgets/gui.h: keys), -1: it has none.
///
/// Latin letters count as they are labelled: Ctrl+Z is the key Z, wherever it lies. Digits count without Shift, where
/// Shift gives them too. A key of another script counts as the Latin letter of the second layout, or else as the letter
/// that lies there on an American keyboard.
int key_place(const PressedKey& key);

}  // namespace erg::ui
