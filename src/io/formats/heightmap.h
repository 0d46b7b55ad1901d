// Heights as grey pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/terrain.h"
#include "io/config/provenance.h"
#include "sim/height_picture.h"

namespace erg::io {

/// Writes the surface as a 16-bit grey PNG, one pixel a cell, north up: black is the lowest point and white the
/// highest. Their heights in m stand in the text chunks "erg:low_m" and "erg:high_m", the cell's side in "erg:cell_m".
void write_heightmap(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance);

/// How a picture is read.
struct HeightPictureOptions {
  Extent grid = {};  ///< what it is brought to; without cells: the picture's own extent
  sim::PictureFit fit = sim::PictureFit::stretch;
  sim::NoDataRule no_data = sim::NoDataRule::refuse;
};

/// Reads a grey PNG of any depth as heights from 0 (black) to 1 (white); grey may be kept as equal colours or in a
/// palette. Row 0 of the result is the picture's lowest row: south. Pixels that are not opaque have no data. The
/// picture is not held whole, an interlaced one excepted. `notes`, where given, gets what is worth telling of the
/// picture. Throws InputError for a file that is missing, damaged or too large, that is no PNG (then with what converts
/// it), that has colours (which are no heights), or pixels without data where these are refused; std::bad_alloc where
/// the memory does not suffice.
sim::HeightPicture read_height_picture(const std::filesystem::path& path, const HeightPictureOptions& options = {},
                                       std::vector<std::string>* notes = nullptr);

/// What a picture says of itself before its pixels are read.
struct HeightPictureHeader {
  Extent extent;
  std::optional<double> cell_size;  ///< m; Erg's own heightmaps say it
};

/// Throws as read_height_picture does.
HeightPictureHeader read_height_header(const std::filesystem::path& path);

}  // namespace erg::io
