// JPEG files: small pictures of land for the gallery.
#pragma once

#include <filesystem>

#include "core/image.h"

namespace erg {

/// Writes a JPEG, whole or not at all. `quality` 1 to 100. Throws InputError when it cannot be written.
void write_jpeg(const std::filesystem::path& path, const RgbImage& image, int quality = 85);

}  // namespace erg
