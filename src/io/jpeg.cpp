#include "io/jpeg.h"

#include <string>

#include "core/errors.h"
#include "io/atomic_file.h"

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

namespace erg {

void write_jpeg(const std::filesystem::path& path, const RgbImage& image, int quality) {
  std::string bytes;
  const auto append = [](void* target, void* data, int size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_jpg_to_func(append, &bytes, image.width, image.height, 3, image.pixels.data(), quality) == 0) {
    throw InputError(path.string(), "the picture cannot be written", "check its size");
  }
  write_file_atomically(path, bytes);
}

}  // namespace erg
