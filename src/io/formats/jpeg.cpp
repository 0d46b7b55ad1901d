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

/// A text as comments of a JPEG, as many as it takes: the marker, the length (two bytes, high one first, that count
/// themselves), and some of the text.
std::string comment(const std::string& text) {
  constexpr std::size_t longest = 0xffff - 2;
  std::string all;
  for (std::size_t at = 0; at < text.size(); at += longest) {
    const std::string part = text.substr(at, longest);
    const std::size_t length = part.size() + 2;
    all += std::string("\xff\xfe") + static_cast<char>(length >> 8) + static_cast<char>(length & 0xff) + part;
  }
  return all;
}

}  // namespace

void write_jpeg(const std::filesystem::path& path, const RgbImage& image, int quality) {
  write_file_atomically(path, encode_jpeg(path, image, quality));
}

void write_run_jpeg(const std::filesystem::path& path, const RgbImage& image, const Provenance& provenance) {
  constexpr int fine = 92;
  constexpr std::size_t start_bytes = 2;  // of the marker that every JPEG begins with
  std::string bytes = encode_jpeg(path, image, fine);
  bytes.insert(start_bytes, comment(comments("", metadata_of_file(path, provenance))));
  write_file_atomically(path, bytes);
}

}  // namespace erg::io
