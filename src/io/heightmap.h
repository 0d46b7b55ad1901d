// Heights as grey pictures.
#pragma once

#include <filesystem>

#include "core/terrain.h"
#include "io/provenance.h"
#include "sim/scene.h"

namespace erg {

/// Writes the surface as a 16-bit grey PNG, one pixel a cell, north up: black is the lowest point and white the
/// highest. Their heights in m stand in the text chunks "erg:low_m" and "erg:high_m", the cell's side in "erg:cell_m".
void write_heightmap(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance);

/// Reads an 8- or 16-bit picture (PNG, also JPEG, BMP, TGA, PGM) as heights from 0 (black) to 1 (white); colours become
/// grey. Row 0 of the result is the picture's lowest row: south. Throws InputError for a missing, damaged or too large
/// file.
HeightPicture read_height_picture(const std::filesystem::path& path);

}  // namespace erg
