// PNG files made by hand, with everything that other programs put into them, and with faults.
#pragma once

#include <zlib.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace erg::test {

inline std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (const int shift : {24, 16, 8, 0}) bytes += static_cast<char>(number >> shift);
  return bytes;
}

inline std::uint32_t crc_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(
      crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

/// A chunk; `damage` is laid over its checksum.
inline std::string png_chunk(const std::string& type, const std::string& data, std::uint32_t damage = 0) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(crc_of(type + data) ^ damage);
}

inline std::string text_chunk(const std::string& key, const std::string& text) {
  return png_chunk("tEXt", key + '\0' + text);
}

enum PngKind { grey = 0, colour = 2, palette = 3, grey_opacity = 4, colour_opacity = 6 };

/// What a PNG is made of. Samples: those of a pixel side by side, row by row from the top.
struct PngBytes {
  int width = 1;
  int height = 1;
  int bits = 16;
  PngKind kind = grey;
  std::vector<int> samples = {0};
  std::string before = {};  ///< chunks before the pixels: PLTE, tRNS, text
  std::string behind = {};  ///< chunks between the pixels and the end
  bool interlaced = false;
  std::uint32_t header_damage = 0;
  std::uint32_t pixels_damage = 0;  ///< of the chunk's checksum
  bool stream_damage = false;       ///< of the checksum within the packed pixels
  std::string signature = "\x89PNG\r\n\x1a\n";

  std::string made() const {
    std::string packed = pack(interlaced ? adam7() : part(0, 0, 1, 1));
    if (stream_damage) packed.back() = static_cast<char>(packed.back() ^ 1);
    std::string header = big_endian(static_cast<std::uint32_t>(width)) + big_endian(static_cast<std::uint32_t>(height));
    for (const int byte : {bits, static_cast<int>(kind), 0, 0, interlaced ? 1 : 0}) header += static_cast<char>(byte);
    return signature + png_chunk("IHDR", header, header_damage) + before + png_chunk("IDAT", packed, pixels_damage) +
           behind + png_chunk("IEND", "");
  }

 private:
  int channels() const { return kind == colour ? 3 : kind == grey_opacity ? 2 : kind == colour_opacity ? 4 : 1; }

  /// Rows of every `dx`th pixel from x0 and every `dy`th row from y0, each after the mark "no filter".
  std::string part(int x0, int y0, int dx, int dy) const {
    std::string rows;
    for (int y = y0; y < height && x0 < width; y += dy) {
      rows += '\0';
      unsigned held = 0;
      int held_bits = 0;
      for (int x = x0; x < width; x += dx) {
        for (int channel = 0; channel < channels(); ++channel) {
          const int value = samples.at(static_cast<std::size_t>((y * width + x) * channels() + channel));
          if (bits == 16) rows += static_cast<char>(value >> 8);
          if (bits >= 8) rows += static_cast<char>(value);
          if (bits >= 8) continue;
          held = held << bits | static_cast<unsigned>(value);
          held_bits += bits;
          if (held_bits == 8) rows += static_cast<char>(held);
          held_bits %= 8;
        }
      }
      if (held_bits > 0) rows += static_cast<char>(held << (8 - held_bits));
    }
    return rows;
  }

  std::string adam7() const {
    constexpr std::array<std::array<int, 4>, 7> passes = {
        {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};
    std::string rows;
    for (const auto& [x0, y0, dx, dy] : passes) rows += part(x0, y0, dx, dy);
    return rows;
  }

  static std::string pack(const std::string& rows) {
    uLongf bytes = compressBound(static_cast<uLong>(rows.size()));
    std::string packed(bytes, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &bytes, reinterpret_cast<const Bytef*>(rows.data()),
             static_cast<uLong>(rows.size()));
    packed.resize(bytes);
    return packed;
  }
};

/// The same file with all its chunks' checksums right.
inline std::string with_right_checksums(std::string png) {
  for (std::size_t at = 8; at + 12 <= png.size();) {
    std::size_t length = 0;
    for (std::size_t byte = at; byte < at + 4; ++byte) length = length << 8 | static_cast<unsigned char>(png[byte]);
    if (length > png.size() - at - 12) break;
    png.replace(at + 8 + length, 4, big_endian(crc_of(std::string_view(png).substr(at + 4, 4 + length))));
    at += 12 + length;
  }
  return png;
}

}  // namespace erg::test
