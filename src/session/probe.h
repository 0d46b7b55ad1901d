// Looking closely at a terrain: one cell, a line through it, how heights and slopes are spread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/terrain.h"
#include "io/config/provenance.h"

namespace erg::session {

/// A cell's place.
struct CellPlace {
  int x = 0;
  int y = 0;
  bool operator==(const CellPlace&) const = default;
};

/// The value of a declared layer at a cell.
struct FieldReading {
  const FieldInfo* info = nullptr;
  double value = 0;
};

/// What stands under the mouse.
struct CellReading {
  CellPlace place;
  std::int32_t mobile = 0;   ///< quanta of sand or snow
  std::int32_t bedrock = 0;  ///< quanta
  double height = 0;         ///< m: the surface
  double thickness = 0;      ///< m of sand or snow
  double slope = 0;          ///< degrees, by central differences
  double uphill = 0;         ///< degrees: bearing toward which the ground rises
  std::vector<FieldReading> fields;

  /// "cell 120, 88   height 4.33 m   13 slabs, 4.33 m thick   slope 12°", then the declared layers.
  std::string text() const;
};
/// The place must lie on the grid.
CellReading read_cell(const Terrain& terrain, CellPlace place);

/// The ground along a straight line between two cells, sampled at most a cell apart.
struct Section {
  CellPlace from;
  CellPlace to;
  std::vector<double> distance;  ///< m from the first cell
  std::vector<double> bedrock;   ///< m
  std::vector<double> surface;   ///< m
};
/// Both places must lie on the grid.
Section cut_section(const Terrain& terrain, CellPlace from, CellPlace to);

/// How values are spread: `counts[i]` of them from lowest + i * width on.
struct Histogram {
  double lowest = 0;
  double width = 1;  ///< of a bar
  std::vector<double> counts;
};
/// Thickness of the mobile layer in quanta: one bar a quantum, or a few quanta where there are more than `most_bars`.
Histogram thickness_histogram(const Terrain& terrain, std::size_t most_bars = 64);
/// Height of the surface in m, in at most `bars` bars of whole quanta.
Histogram height_histogram(const Terrain& terrain, std::size_t bars = 48);
/// Slopes in degrees by central differences, 0 to 90 in bars of `width` degrees.
Histogram slope_histogram(const Terrain& terrain, double width = 2);

// Each as CSV with its provenance; throws InputError when it cannot be written.
void write_section(const std::filesystem::path& path, const Section& section, const io::Provenance& provenance);
void write_histogram(const std::filesystem::path& path, const Histogram& histogram, const std::string& quantity,
                     const io::Provenance& provenance);

}  // namespace erg::session
