#include "ui/widgets/fonts.h"

#include <fontconfig/fontconfig.h>

#include <filesystem>
#include <vector>

namespace erg::ui {

/// Gives back what fontconfig made.
struct FontconfigFree {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
  void operator()(FcCharSet* letters) const { FcCharSetDestroy(letters); }
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
};

namespace {

using Pattern = std::unique_ptr<FcPattern, FontconfigFree>;
using Letters = std::unique_ptr<FcCharSet, FontconfigFree>;

/// Whether the interface can draw with it: outlines, without colours, TrueType or CFF.
bool is_drawable(const FcPattern& font) {
  FcBool outlines = FcFalse;
  FcBool colours = FcFalse;
  FcChar8* format = nullptr;
  FcPatternGetBool(&font, FC_OUTLINE, 0, &outlines);
  FcPatternGetBool(&font, FC_COLOR, 0, &colours);
  if (outlines != FcTrue || colours == FcTrue) return false;
  if (FcPatternGetString(&font, FC_FONTFORMAT, 0, &format) != FcResultMatch) return false;
  const std::string_view name = reinterpret_cast<const char*>(format);
  return name == "TrueType" || name == "CFF";
}

bool has_letter(const FcPattern& font, char32_t letter) {
  FcCharSet* letters = nullptr;
  return FcPatternGetCharSet(&font, FC_CHARSET, 0, &letters) == FcResultMatch &&
         FcCharSetHasChar(letters, letter) == FcTrue;
}

Pattern wanted_font(char32_t letter) {
  Pattern wanted(FcPatternCreate());
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcPatternAddBool(wanted.get(), FC_OUTLINE, FcTrue);
  FcPatternAddBool(wanted.get(), FC_COLOR, FcFalse);
  if (letter != 0) {
    const Letters letters(FcCharSetCreate());
    FcCharSetAddChar(letters.get(), letter);
    FcPatternAddCharSet(wanted.get(), FC_CHARSET, letters.get());
  }
  return wanted;
}

std::optional<FontFile> file_of(const FcPattern& font) {
  FcChar8* path = nullptr;
  int face = 0;
  if (FcPatternGetString(&font, FC_FILE, 0, &path) != FcResultMatch) return std::nullopt;
  FcPatternGetInteger(&font, FC_INDEX, 0, &face);
  return FontFile{reinterpret_cast<const char*>(path), face & 0xffff};  // above: which of a variable font's weights
}

}  // namespace

struct FontFinder::Hidden {
  std::unique_ptr<FcConfig, FontconfigFree> config;
  std::vector<std::unique_ptr<FcPattern, FontconfigFree>> found;

  /// The best sans-serif font, which has the letter where that is not 0.
  std::optional<FontFile> best(char32_t letter) {
    if (config == nullptr) config.reset(FcInitLoadConfigAndFonts());
    if (config == nullptr) return std::nullopt;
    const Pattern wanted = wanted_font(letter);
    FcConfigSubstitute(config.get(), wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    FcFontSet* const fonts = FcFontSort(config.get(), wanted.get(), FcTrue, nullptr, &result);
    std::optional<FontFile> file;
    for (int i = 0; fonts != nullptr && i < fonts->nfont && !file; ++i) {
      FcPattern* const font = fonts->fonts[i];
      if (!is_drawable(*font) || (letter != 0 && !has_letter(*font, letter))) continue;
      file = file_of(*font);
      FcPatternReference(font);
      found.emplace_back(font);
    }
    if (fonts != nullptr) FcFontSetDestroy(fonts);
    return file;
  }
};

FontFinder::FontFinder() : hidden_(std::make_unique<Hidden>()) {}
FontFinder::~FontFinder() = default;

std::optional<FontFile> FontFinder::interface_font() {
  // As Debian, Fedora, Arch and others have it.
  for (const char* const folder : {"truetype/dejavu", "dejavu", "dejavu-sans-fonts", "TTF", "truetype", "ttf-dejavu"}) {
    const std::string path = std::string("/usr/share/fonts/") + folder + "/DejaVuSans.ttf";
    std::error_code failed;
    if (std::filesystem::is_regular_file(path, failed)) return FontFile{path};
  }
  return hidden_->best(0);
}

std::optional<FontFile> FontFinder::font_with(char32_t letter) {
  for (const Pattern& font : hidden_->found) {
    if (has_letter(*font, letter)) return file_of(*font);
  }
  return hidden_->best(letter);
}

char32_t take_letter(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  text.remove_prefix(1);
  if (first < 0x80) return first;
  const int more = first >= 0xf0 && first < 0xf8 ? 3 : first >= 0xe0 && first < 0xf0 ? 2 : first >= 0xc2 ? 1 : 0;
  constexpr char32_t damaged = 0xfffd;
  if (more == 0 || first >= 0xf8) return damaged;
  char32_t letter = first & (0x3fu >> more);
  for (int i = 0; i < more; ++i) {
    if (text.empty() || (static_cast<unsigned char>(text.front()) & 0xc0) != 0x80) return damaged;
    letter = (letter << 6) | (static_cast<unsigned char>(text.front()) & 0x3fu);
    text.remove_prefix(1);
  }
  return letter;
}

std::string utf8_of(char32_t letter) {
  const auto part = [letter](int shift, unsigned mark, unsigned mask) {
    return static_cast<char>(mark | ((static_cast<unsigned>(letter) >> shift) & mask));
  };
  if (letter < 0x80) return {part(0, 0, 0x7f)};
  if (letter < 0x800) return {part(6, 0xc0, 0x1f), part(0, 0x80, 0x3f)};
  if (letter < 0x10000) return {part(12, 0xe0, 0x0f), part(6, 0x80, 0x3f), part(0, 0x80, 0x3f)};
  return {part(18, 0xf0, 0x07), part(12, 0x80, 0x3f), part(6, 0x80, 0x3f), part(0, 0x80, 0x3f)};
}

}  // namespace erg::ui
