// PNG encoding and reading of text chunks, shared by pictures and heightmaps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/provenance.h"

namespace erg {

/// Pixels as PNG has them: rows from the top, samples of 8 or 16 bits in the machine's byte order.
struct PngPixels {
  int width = 0;
  int height = 0;
  int bits = 8;      ///< 8 or 16 a sample
  int channels = 3;  ///< 1 grey, 3 colour, 4 colour with opacity
  const void* first = nullptr;
};

/// The whole file as bytes. Throws InputError with `path` as the place when the encoder refuses.
std::string encode_png(const PngPixels& pixels, const MetadataEntries& entries, const std::filesystem::path& path);

}  // namespace erg
