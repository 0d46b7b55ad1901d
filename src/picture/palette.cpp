#include "picture/palette.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>

#include "core/errors.h"

namespace erg::picture {
namespace {

Colour from_hex(std::uint32_t rgb) {
  const auto part = [rgb](int shift) { return static_cast<float>(rgb >> shift & 0xff) / 255.0f; };
  return {part(16), part(8), part(0)};
}

Palette make_palette(std::string name, std::string meaning, std::initializer_list<std::uint32_t> points) {
  Palette palette{std::move(name), std::move(meaning), {}};
  for (const std::uint32_t point : points) palette.points.push_back(from_hex(point));
  return palette;
}

const std::vector<Palette>& table() {
  static const std::vector<Palette> all = {
      make_palette("sand", "dry sand, darker in the hollows", {0xb98a55, 0xd3a76c, 0xe2bd83, 0xeed09c, 0xf7e2b6}),
      make_palette("RdYlGn", "green low, red high, as in Cimbura 2022 (colours of ColorBrewer)",
                   {0x006837, 0x1a9850, 0x66bd63, 0xa6d96a, 0xd9ef8b, 0xffffbf, 0xfee08b, 0xfdae61, 0xf46d43, 0xd73027,
                    0xa50026}),
      make_palette(
          "cividis", "even in lightness, for every kind of colour vision (Nunez et al. 2018)",
          {0x00224e, 0x123570, 0x3b496c, 0x575d6d, 0x707173, 0x8a8678, 0xa59c74, 0xc3b369, 0xe1cc55, 0xfee838}),
      make_palette(
          "batlow", "even in lightness, with more hues (Crameri 2018)",
          {0x011959, 0x103f60, 0x1c5a62, 0x3c6d56, 0x687b3e, 0x9d892b, 0xd29343, 0xf8a17b, 0xfdb7bc, 0xfaccfa}),
      make_palette("grey", "black to white", {0x000000, 0xffffff}),
      make_palette("vegetation", "bare sand to dense green",
                   {0xe2bd83, 0xc3b872, 0x93a65a, 0x5f8c45, 0x356f34, 0x1b4d26}),
  };
  return all;
}

}  // namespace

Colour blend(Colour first, Colour second, double t) {
  const auto share = static_cast<float>(std::clamp(t, 0.0, 1.0));
  const auto mix = [share](float from, float to) { return from + (to - from) * share; };
  return {mix(first.red, second.red), mix(first.green, second.green), mix(first.blue, second.blue)};
}

Colour Palette::at(double t) const {
  if (!(t > 0)) return points.front();
  if (t >= 1) return points.back();
  const double position = t * static_cast<double>(points.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  return blend(points[below], points[below + 1], position - static_cast<double>(below));
}

const std::vector<std::string>& palette_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Palette& palette : table()) all.push_back(palette.name);
    return all;
  }();
  return names;
}

const Palette& find_palette(std::string_view name) {
  const auto found = std::find_if(table().begin(), table().end(), [&](const Palette& one) { return one.name == name; });
  if (found != table().end()) return *found;
  throw InputError("palette", "there is no palette " + quote(name), suggestion(name, palette_names()));
}

}  // namespace erg::picture
