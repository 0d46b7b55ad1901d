#include "core/terrain.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <utility>

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

Terrain::Terrain(Extent extent, double cell_size, double quantum, Boundary boundary)
    : cell_size_(cell_size), quantum_(quantum), boundary_(boundary), bedrock_(extent), mobile_(extent) {}

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

std::uint64_t state_hash(const Terrain& terrain) {
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
