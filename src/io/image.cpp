#include "io/image.h"

#include "io/atomic_file.h"
#include "io/png_file.h"

namespace erg {

void write_png(const std::filesystem::path& path, const RgbImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 8, 3, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const RgbaImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 8, 4, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const GreyImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 16, 1, image.pixels.data()}, entries, path));
}

}  // namespace erg
