#include "picture/label.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

namespace erg::picture {
namespace {

constexpr const char* font_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

// The installed font, read once.
struct Font {
  Font() {
    std::ifstream file(font_file, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    works = !bytes.empty() && stbtt_InitFont(&info, data, stbtt_GetFontOffsetForIndex(data, 0)) != 0;
  }
  std::string bytes;
  stbtt_fontinfo info{};
  bool works = false;
};

const Font& font() {
  static const Font installed;
  return installed;
}

// The characters of a UTF-8 text; a broken byte becomes a question mark.
std::vector<int> characters(std::string_view text) {
  std::vector<int> all;
  for (std::size_t at = 0; at < text.size();) {
    const auto lead = static_cast<unsigned char>(text[at++]);
    const int following = lead < 0x80 ? 0 : lead >= 0xf0 ? 3 : lead >= 0xe0 ? 2 : lead >= 0xc0 ? 1 : -1;
    int character = following == 0 ? lead : following > 0 ? lead & (0x3f >> following) : '?';
    for (int more = 0; more < following && at < text.size(); ++more) {
      character = character << 6 | (static_cast<unsigned char>(text[at++]) & 0x3f);
    }
    all.push_back(character);
  }
  return all;
}

// Walks along a line of text: calls place(character, pen), pen in pixels from the left; returns the whole width.
template <typename Place>
double set_line(std::string_view text, float scale, const Place& place) {
  double pen = 0;
  for (const int character : characters(text)) {
    place(character, pen);
    int advance = 0;
    int bearing = 0;
    stbtt_GetCodepointHMetrics(&font().info, character, &advance, &bearing);
    pen += scale * static_cast<float>(advance);
  }
  return pen;
}

}  // namespace

int label_width(std::string_view text, double size) {
  if (!font().works) return 0;
  const float scale = stbtt_ScaleForPixelHeight(&font().info, static_cast<float>(size));
  return static_cast<int>(std::ceil(set_line(text, scale, [](int, double) {})));
}

void draw_label(RgbImage& image, std::string_view text, int x, int y, double size, Colour colour) {
  if (!font().works) return;
  const float scale = stbtt_ScaleForPixelHeight(&font().info, static_cast<float>(size));
  set_line(text, scale, [&](int character, double pen) {
    const double start = std::floor(pen);
    int left = 0, top = 0, right = 0, bottom = 0;
    const auto shift = static_cast<float>(pen - start);
    stbtt_GetCodepointBitmapBoxSubpixel(&font().info, character, scale, scale, shift, 0, &left, &top, &right, &bottom);
    const int wide = right - left;
    const int high = bottom - top;
    if (wide <= 0 || high <= 0) return;
    std::vector<unsigned char> ink(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
    stbtt_MakeCodepointBitmapSubpixel(&font().info, ink.data(), wide, high, wide, scale, scale, shift, 0, character);
    for (int row = 0; row < high; ++row) {
      for (int column = 0; column < wide; ++column) {
        const double opacity = ink[static_cast<std::size_t>(row) * static_cast<std::size_t>(wide) + column] / 255.0;
        image.cover(x + static_cast<int>(start) + left + column, y + top + row, colour, opacity);
      }
    }
  });
}

}  // namespace erg::picture
