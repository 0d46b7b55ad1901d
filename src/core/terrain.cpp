#include "core/terrain.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "core/errors.h"
#include "core/random.h"

namespace erg {

const Field* find_field(const std::vector<Field>& fields, std::string_view key) {
  const auto found =
      std::ranges::find(fields, key, [](const Field& field) { return std::string_view(field.info.key); });
  return found == fields.end() ? nullptr : &*found;
}

Field* find_field(std::vector<Field>& fields, std::string_view key) {
  return const_cast<Field*>(find_field(std::as_const(fields), key));
}

namespace {

Extent accepted(Extent extent) {
  const auto fits = [](int side) { return side >= smallest_side && side <= largest_side; };
  if (fits(extent.nx) && fits(extent.ny)) return extent;
  throw InputError("terrain",
                   "it would have " + std::to_string(extent.nx) + " x " + std::to_string(extent.ny) + " cells",
                   "give each side " + std::to_string(smallest_side) + " to " + std::to_string(largest_side));
}

double accepted_length(double length, const char* of_what) {
  if (std::isfinite(length) && length > 0) return length;
  throw InputError("terrain", std::string("the ") + of_what + " is no length", "give a positive number of metres");
}

}  // namespace

Terrain::Terrain(Extent extent, double cell_size, double quantum, Boundary boundary)
    : cell_size_(accepted_length(cell_size, "cell size")),
      quantum_(accepted_length(quantum, "height of a slab")),
      boundary_(boundary),
      bedrock_(accepted(extent)),
      mobile_(extent) {}

Grid<std::int32_t>& Terrain::edit_bedrock() {
  stamp_.renew();
  return bedrock_;
}

Grid<std::int32_t>& Terrain::edit_mobile() {
  stamp_.renew();
  return mobile_;
}

std::vector<Field>& Terrain::edit_fields() {
  fields_stamp_.renew();
  return fields_;
}

std::int64_t Terrain::total_mobile() const {
  return std::accumulate(mobile_.cells().begin(), mobile_.cells().end(), std::int64_t{0});
}

void Terrain::open_ledger() { ledger_ = {total_mobile(), 0, 0}; }

void check_whole(const Terrain& terrain) {
  if (terrain.extent().cells() == 0) throw InputError("terrain", "it has no cells", "make one of at least 1 x 1");
  const auto check = [&](Extent extent, const std::string& layer) {
    if (extent == terrain.extent()) return;
    throw InputError("terrain", layer + " differs in extent from the bedrock", "give all layers the same extent");
  };
  check(terrain.mobile().extent(), "the mobile layer");
  for (const Field& field : terrain.fields()) check(field.values.extent(), "the field " + field.info.key);
}

std::uint64_t state_hash(const Terrain& terrain) {
  check_whole(terrain);
  std::uint64_t hash = mix64(static_cast<std::uint64_t>(terrain.nx()) << 32 | static_cast<std::uint32_t>(terrain.ny()));
  const auto absorb = [&hash](std::uint32_t low, std::uint32_t high) {
    hash = mix64(hash ^ (static_cast<std::uint64_t>(high) << 32 | low));
  };
  const auto bedrock = terrain.bedrock().cells();
  const auto mobile = terrain.mobile().cells();
  for (std::size_t cell = 0; cell < mobile.size(); ++cell) {
    absorb(static_cast<std::uint32_t>(mobile[cell]), static_cast<std::uint32_t>(bedrock[cell]));
  }
  for (const Field& field : terrain.fields()) {
    for (const float value : field.values.cells()) absorb(std::bit_cast<std::uint32_t>(value), 0);
  }
  return hash;
}

}  // namespace erg
