// What a picture shows: a terrain and what lies over it. The renderer knows nothing else of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/material.h"
#include "core/terrain.h"
#include "core/trajectory.h"

namespace erg::render {

/// A const view; everything it points to must outlive the drawing.
struct TerrainView {
  const Terrain* terrain = nullptr;
  std::vector<const Field*> fields;    ///< more fields besides the terrain's own: wind shadow, flux, age
  std::optional<double> wind;          ///< degrees: bearing of the wind, where it blows from
  Material material = Material::sand;  ///< of the mobile layer
  std::vector<Trajectory> trajectories;
  /// Changes whenever anything here changes, so that an unchanged view costs nothing; 0: unknown, look at all of it.
  std::uint64_t version = 0;

  /// The field with this key, of the view or of the terrain; null when there is none.
  const Field* find_field(const std::string& key) const;
  /// The keys of all its fields.
  std::vector<std::string> field_keys() const;
};

}  // namespace erg::render
