#include "io/formats/jpeg.h"

#include <string>

#include "core/errors.h"
#include "io/files/atomic_file.h"
#include "io/formats/comments.h"

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace erg::io {

using picture::RgbImage;

namespace {

std::string encode_jpeg(const std::filesystem::path& path, const RgbImage& image, int quality) {
  std::string bytes;
  const auto append = [](void* target, void* data, int size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_jpg_to_func(append, &bytes, image.width, image.height, 3, image.pixels.data(), quality) == 0) {
    throw InputError(path.string(), "the picture cannot be written", "check its size");
  }
  return bytes;
}

/// A comment of a JPEG: its marker, its length (two bytes, high one first, that count themselves), its text.
std::string comment(const std::string& text) {
  const std::size_t length = text.size() + 2;
  return std::string("\xff\xfe") + static_cast<char>(length >> 8) + static_cast<char>(length & 0xff) + text;
}

}  // namespace

void write_jpeg(const std::filesystem::path& path, const RgbImage& image, int quality) {
  write_file_atomically(path, encode_jpeg(path, image, quality));
}

void write_run_jpeg(const std::filesystem::path& path, const RgbImage& image, const Provenance& provenance) {
  constexpr int fine = 92;
  constexpr std::size_t start_bytes = 2;  // of the marker that every JPEG begins with
  std::string bytes = encode_jpeg(path, image, fine);
  bytes.insert(start_bytes, comment(comments("", provenance)));
  keep_config_beside(path, provenance);
  write_file_atomically(path, bytes);
}

}  // namespace erg::io
