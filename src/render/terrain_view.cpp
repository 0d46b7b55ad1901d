#include "render/terrain_view.h"

namespace erg {

const Field* TerrainView::find_field(const std::string& key) const {
  for (const Field* field : fields) {
    if (field->info.key == key) return field;
  }
  if (terrain == nullptr) return nullptr;
  for (const Field& field : terrain->fields()) {
    if (field.info.key == key) return &field;
  }
  return nullptr;
}

std::vector<std::string> TerrainView::field_keys() const {
  std::vector<std::string> keys;
  for (const Field* field : fields) keys.push_back(field->info.key);
  if (terrain == nullptr) return keys;
  for (const Field& field : terrain->fields()) keys.push_back(field.info.key);
  return keys;
}

}  // namespace erg
