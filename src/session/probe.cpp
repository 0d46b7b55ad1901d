#include "session/probe.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/number_text.h"
#include "core/surface_range.h"
#include "core/units.h"
#include "forcing/bearing.h"
#include "io/formats/table.h"

namespace erg::session {

using io::Provenance;
using io::write_table;

namespace {

/// The index one cell on: around the torus, or held at an open edge.
int beside(int index, int step, int count, Boundary boundary) {
  return boundary == Boundary::torus ? wrap(index + step, count) : std::clamp(index + step, 0, count - 1);
}

/// Rise of the surface a cell length, by central differences; quanta. At an open edge it is the one-sided one.
struct Rise {
  double east = 0;
  double north = 0;
};

Rise rise_at(const Terrain& terrain, int x, int y) {
  const int west = beside(x, -1, terrain.nx(), terrain.boundary());
  const int east = beside(x, 1, terrain.nx(), terrain.boundary());
  const int south = beside(y, -1, terrain.ny(), terrain.boundary());
  const int north = beside(y, 1, terrain.ny(), terrain.boundary());
  const double width = terrain.boundary() == Boundary::torus || (x > 0 && x + 1 < terrain.nx()) ? 2 : 1;
  const double depth = terrain.boundary() == Boundary::torus || (y > 0 && y + 1 < terrain.ny()) ? 2 : 1;
  return {(terrain.height(east, y) - terrain.height(west, y)) / width,
          (terrain.height(x, north) - terrain.height(x, south)) / depth};
}

double slope_of(const Terrain& terrain, Rise rise) {
  return degrees(std::atan(std::hypot(rise.east, rise.north) * terrain.quantum() / terrain.cell_size()));
}

void count(Histogram& histogram, double value) {
  const double place = std::floor((value - histogram.lowest) / histogram.width);
  const double last = static_cast<double>(histogram.counts.size()) - 1;
  histogram.counts[static_cast<std::size_t>(std::clamp(place, 0.0, last))] += 1;
}

}  // namespace

std::string CellReading::text() const {
  char text[160];
  std::snprintf(text, sizeof text, "cell %d, %d   height %.2f m   %d slab%s, %.2f m thick   slope %.0f°", place.x,
                place.y, height, mobile, mobile == 1 ? "" : "s", thickness, slope);
  std::string all = text;
  for (const FieldReading& field : fields) {
    std::snprintf(text, sizeof text, "%.4g", field.value);
    all.append("   ").append(field.info->label).append(" ").append(text);
    if (!field.info->unit.empty()) all.append(" ").append(unit_text(field.info->unit));
  }
  return all;
}

CellReading read_cell(const Terrain& terrain, CellPlace place) {
  check_whole(terrain);
  CellReading reading;
  reading.place = place;
  reading.mobile = terrain.mobile()(place.x, place.y);
  reading.bedrock = terrain.bedrock()(place.x, place.y);
  reading.height = terrain.metres(reading.mobile + reading.bedrock);
  reading.thickness = terrain.metres(reading.mobile);
  const Rise rise = rise_at(terrain, place.x, place.y);
  reading.slope = slope_of(terrain, rise);
  if (rise.east != 0 || rise.north != 0) {
    const double clockwise_from_north = degrees(std::atan2(rise.east, rise.north));
    reading.uphill = fold_bearing(clockwise_from_north);
  }
  for (const Field& field : terrain.fields()) {
    reading.fields.push_back({&field.info, field.values(place.x, place.y)});
  }
  return reading;
}

Section cut_section(const Terrain& terrain, CellPlace from, CellPlace to) {
  check_whole(terrain);
  Section section{from, to, {}, {}, {}};
  const int dx = to.x - from.x;
  const int dy = to.y - from.y;
  const int steps = std::max(std::abs(dx), std::abs(dy));
  const double length = std::hypot(dx, dy) * terrain.cell_size();
  for (int i = 0; i <= steps; ++i) {
    const double part = steps > 0 ? static_cast<double>(i) / steps : 0;
    const int x = from.x + static_cast<int>(std::lround(part * dx));
    const int y = from.y + static_cast<int>(std::lround(part * dy));
    section.distance.push_back(part * length);
    section.bedrock.push_back(terrain.metres(terrain.bedrock()(x, y)));
    section.surface.push_back(terrain.metres(terrain.height(x, y)));
  }
  return section;
}

Histogram thickness_histogram(const Terrain& terrain, std::size_t most_bars) {
  check_whole(terrain);
  Histogram histogram;
  const auto cells = terrain.mobile().cells();
  if (cells.empty()) return histogram;
  const auto largest = static_cast<std::size_t>(*std::ranges::max_element(cells));
  const std::size_t quanta = largest / std::max<std::size_t>(most_bars, 1) + 1;
  histogram.width = static_cast<double>(quanta);
  histogram.counts.assign(largest / quanta + 1, 0);
  for (const std::int32_t mobile : cells) count(histogram, mobile);
  return histogram;
}

Histogram height_histogram(const Terrain& terrain, std::size_t bars) {
  check_whole(terrain);
  Histogram histogram;
  if (terrain.extent().cells() == 0) return histogram;
  const auto [low, high] = surface_range(terrain);
  // Bars of whole quanta: else some would hold two heights and their neighbours one.
  const std::int64_t levels = static_cast<std::int64_t>(high) - low + 1;
  const auto most = static_cast<std::int64_t>(std::max<std::size_t>(bars, 1));
  const std::int64_t quanta = (levels + most - 1) / most;
  histogram.lowest = terrain.metres(low);
  histogram.width = terrain.quantum() * static_cast<double>(quanta);
  histogram.counts.assign(static_cast<std::size_t>((levels + quanta - 1) / quanta), 0);
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) {
      histogram.counts[static_cast<std::size_t>((terrain.height(x, y) - low) / quanta)] += 1;
    }
  }
  return histogram;
}

Histogram slope_histogram(const Terrain& terrain, double width) {
  check_whole(terrain);
  Histogram histogram{0, width, {}};
  histogram.counts.assign(static_cast<std::size_t>(std::ceil(90 / width)), 0);
  for (int y = 0; y < terrain.ny(); ++y) {
    for (int x = 0; x < terrain.nx(); ++x) count(histogram, slope_of(terrain, rise_at(terrain, x, y)));
  }
  return histogram;
}

void write_section(const std::filesystem::path& path, const Section& section, const Provenance& provenance) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < section.distance.size(); ++i) {
    rows.push_back({section.distance[i], section.bedrock[i], section.surface[i]});
  }
  write_table(path, {"distance_m", "bedrock_m", "surface_m"}, rows, provenance);
}

void write_histogram(const std::filesystem::path& path, const Histogram& histogram, const std::string& quantity,
                     const Provenance& provenance) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
    const double from = histogram.lowest + static_cast<double>(i) * histogram.width;
    rows.push_back({from, from + histogram.width, histogram.counts[i]});
  }
  write_table(path, {quantity + "_from", quantity + "_to", "cells"}, rows, provenance);
}

}  // namespace erg::session
