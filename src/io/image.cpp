#include "io/image.h"

#include "io/atomic_file.h"
#include "io/png_file.h"

namespace erg {
namespace {

bool is_opaque(const RgbaImage& image) {
  for (std::size_t opacity = 3; opacity < image.pixels.size(); opacity += 4) {
    if (image.pixels[opacity] != 255) return false;
  }
  return true;
}

}  // namespace

void write_png(const std::filesystem::path& path, const RgbImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 8, 3, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const RgbaImage& image, const MetadataEntries& entries) {
  if (is_opaque(image)) return write_png(path, over(image, {}), entries);
  write_file_atomically(path, encode_png({image.width, image.height, 8, 4, image.pixels.data()}, entries, path));
}

void write_png(const std::filesystem::path& path, const GreyImage& image, const MetadataEntries& entries) {
  write_file_atomically(path, encode_png({image.width, image.height, 16, 1, image.pixels.data()}, entries, path));
}

}  // namespace erg
