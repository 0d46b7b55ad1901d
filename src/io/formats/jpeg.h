// JPEG files: pictures of terrain, small ones for the gallery among them.
#pragma once

#include <filesystem>

#include "io/config/provenance.h"
#include "picture/image.h"

namespace erg::io {

/// Writes a JPEG, whole or not at all. `quality` 1 to 100. Throws InputError when it cannot be written.
void write_jpeg(const std::filesystem::path& path, const picture::RgbImage& image, int quality = 85);

/// The same for a picture of a run: its provenance (metadata) stands in the JPEG's comment, an entry a line, and a long
/// config beside the file.
void write_run_jpeg(const std::filesystem::path& path, const picture::RgbImage& image, const Provenance& provenance);

}  // namespace erg::io
