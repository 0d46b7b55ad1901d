// Where letters come from: DejaVu Sans, and for those that it lacks whatever fontconfig finds on the machine.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace erg::ui {

/// A font of outlines in a file that may hold several.
struct FontFile {
  std::string path;
  int face = 0;
  bool operator==(const FontFile&) const = default;
};

/// Finds fonts. What fontconfig knows is read when it is first asked.
class FontFinder {
 public:
  FontFinder();
  ~FontFinder();
  FontFinder(const FontFinder&) = delete;
  FontFinder& operator=(const FontFinder&) = delete;

  /// The font of the interface: DejaVu Sans where distributions keep it, else fontconfig's choice of a sans-serif. None
  /// where there is no font at all.
  std::optional<FontFile> interface_font();
  /// A font that has this letter: one that was found before, or as fontconfig chooses by the person's language. None
  /// where no font has it.
  std::optional<FontFile> font_with(char32_t letter);

 private:
  struct Hidden;
  std::unique_ptr<Hidden> hidden_;
};

/// The first letter of a UTF-8 text, which is taken from it. Bytes that are no UTF-8 are U+FFFD.
char32_t take_letter(std::string_view& text);
/// A letter as UTF-8.
std::string utf8_of(char32_t letter);

}  // namespace erg::ui
