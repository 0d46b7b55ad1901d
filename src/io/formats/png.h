// PNG files, written; io/formats/png_reader.h reads them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "io/config/provenance.h"
#include "picture/image.h"

namespace erg::io {

/// A grey picture of 16 bits, row 0 at the top.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> pixels;
};

/// Writes a PNG, whole or not at all, with the entries as text chunks; without opacity where all of it is opaque.
/// Throws InputError when it cannot be written.
void write_png(const std::filesystem::path& path, const picture::RgbImage& image, const MetadataEntries& entries);
void write_png(const std::filesystem::path& path, const picture::RgbaImage& image, const MetadataEntries& entries);
void write_png(const std::filesystem::path& path, const GreyImage& image, const MetadataEntries& entries);

/// The same for a picture of a run: the provenance as entries, and a long config beside the file.
void write_run_png(const std::filesystem::path& path, const picture::RgbImage& image, const Provenance& provenance);
void write_run_png(const std::filesystem::path& path, const picture::RgbaImage& image, const Provenance& provenance);

}  // namespace erg::io
