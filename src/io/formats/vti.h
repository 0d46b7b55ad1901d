// Terrains for ParaView.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "core/terrain.h"
#include "io/config/provenance.h"

namespace erg::io {

/// Writes VTK XML image data (.vti), one point at each cell's centre, values appended in binary: "surface", "sand" and
/// "bedrock" in m, "shadow" (1 dark) where a map is given, and every declared field and each of `more` under its key.
/// The provenance stands in the field data as strings, and as "TimeValue", which ParaView takes for the time of the
/// file, the days of the world since step 0, or the step where steps have no time of their own. In ParaView: Warp By
/// Scalar with "surface". Throws InputError when it cannot be written.
void write_vti(const std::filesystem::path& path, const Terrain& terrain, const Grid<std::uint8_t>* shadow,
               const Provenance& provenance, std::span<const Field> more = {});

}  // namespace erg::io
