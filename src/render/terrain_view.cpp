#include "render/terrain_view.h"

#include <algorithm>

namespace erg::render {

const Field* TerrainView::find_field(const std::string& key) const {
  const auto own = std::ranges::find_if(fields, [&key](const Field* field) { return field->info.key == key; });
  if (own != fields.end()) return *own;
  return terrain == nullptr ? nullptr : erg::find_field(terrain->fields(), key);
}

std::vector<std::string> TerrainView::field_keys() const {
  std::vector<std::string> keys;
  for (const Field* field : fields) keys.push_back(field->info.key);
  if (terrain == nullptr) return keys;
  for (const Field& field : terrain->fields()) keys.push_back(field.info.key);
  return keys;
}

}  // namespace erg::render
