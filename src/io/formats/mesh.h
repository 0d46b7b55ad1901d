// Terrains as triangles, for 3D programs and printers. Lengths in m, x east, y north, z up.
#pragma once

#include <filesystem>
#include <functional>

#include "core/terrain.h"
#include "io/config/provenance.h"

namespace erg::io {

/// Told the part done (0 to 1) now and then; false stops the writing.
using WriteProgress = std::function<bool(double)>;

/// Thrown when a WriteProgress said to stop. The file is as it was before.
struct StoppedWriting {};

// Each writes the surface with one corner at each cell's centre and two triangles between four of them, whole or not at
// all; the seam of a torus is not closed. All throw InputError when the file cannot be written. The grid must have two
// cells each way at least.

/// Wavefront OBJ: text, the provenance in comments.
void write_obj(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance,
               const WriteProgress& progress = {});

/// PLY, binary (little endian), with "thickness" of the mobile layer in m at each corner; the provenance in comments.
void write_ply(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance,
               const WriteProgress& progress = {});

/// STL, binary: a closed body with side walls and a flat floor, a tenth of the shorter side below the lowest point. Its
/// header holds program, model, seed and step only: the format has room for no more.
void write_stl(const std::filesystem::path& path, const Terrain& terrain, const Provenance& provenance,
               const WriteProgress& progress = {});

}  // namespace erg::io
