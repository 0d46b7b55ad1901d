#include "session/brush.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/errors.h"
#include "core/number_text.h"
#include "models/slab/terrain_heights.h"

namespace erg::session {

using models::highest_terrain;

namespace {

/// A cell that the stamp touches, and how much of its amount that cell gets, 0 to 1.
struct Touch {
  std::size_t cell = 0;
  double share = 0;
};

/// (1 - (d/r)^2)^2: 1 in the middle, level there and at the rim.
double falloff(double squared_distance, double radius) {
  const double rest = 1 - squared_distance / (radius * radius);
  return rest > 0 ? rest * rest : 0;
}

/// First and last index of cells along one side that the stamp may reach; on a torus each cell once.
struct Reach {
  int first = 0;
  int last = 0;
};

Reach reach(double middle, double radius, int count, bool torus) {
  const double nearest = std::clamp(middle, -2.0 * largest_side, 2.0 * largest_side);
  Reach cells{static_cast<int>(std::floor(nearest - radius)), static_cast<int>(std::ceil(nearest + radius))};
  if (!torus) return {std::max(cells.first, 0), std::min(cells.last, count - 1)};
  if (cells.last - cells.first + 1 > count) {
    cells.first = static_cast<int>(std::floor(nearest)) - count / 2;
    cells.last = cells.first + count - 1;
  }
  return cells;
}

std::vector<Touch> touches(const Terrain& terrain, const BrushStamp& stamp) {
  std::vector<Touch> found;
  const bool torus = terrain.boundary() == Boundary::torus;
  const Reach columns = reach(stamp.x, stamp.radius, terrain.nx(), torus);
  const Reach rows = reach(stamp.y, stamp.radius, terrain.ny(), torus);
  for (int y = rows.first; y <= rows.last; ++y) {
    for (int x = columns.first; x <= columns.last; ++x) {
      const double dx = x + 0.5 - stamp.x;
      const double dy = y + 0.5 - stamp.y;
      const double share = falloff(dx * dx + dy * dy, stamp.radius);
      if (share == 0) continue;
      found.push_back({terrain.mobile().index(wrap(x, terrain.nx()), wrap(y, terrain.ny())), share});
    }
  }
  return found;
}

void check(const BrushStamp& stamp) {
  if (!(stamp.radius >= smallest_brush && stamp.radius <= largest_brush)) {
    throw InputError("brush", "the radius is out of range",
                     "give " + format_shortest(smallest_brush) + " to " + format_shortest(largest_brush) + " cells");
  }
  if (stamp.material == BrushMaterial::field && !std::isfinite(stamp.strength)) {
    throw InputError("brush", "the strength is no number", "give one");
  }
  if (std::abs(static_cast<std::int64_t>(stamp.amount)) > highest_terrain) {
    throw InputError("brush", "the amount is out of range",
                     "give at most " + std::to_string(highest_terrain) + " slabs");
  }
}

bool apply_to_field(Terrain& terrain, const BrushStamp& stamp, const std::vector<Touch>& touched) {
  const auto same_key = [&](const Field& field) { return field.info.key == stamp.field; };
  const auto place = std::ranges::find_if(terrain.fields(), same_key) - terrain.fields().begin();
  if (place == static_cast<std::ptrdiff_t>(terrain.fields().size())) {
    throw InputError("brush", "this model has no layer " + quote(stamp.field), "choose another");
  }
  Field& field = terrain.edit_fields()[static_cast<std::size_t>(place)];
  bool changed = false;
  for (const Touch& touch : touched) {
    const double wanted = field.values[touch.cell] + stamp.strength * touch.share;
    const auto kept = static_cast<float>(std::clamp(wanted, field.info.minimum, field.info.maximum));
    changed = changed || kept != field.values[touch.cell];
    field.values[touch.cell] = kept;
  }
  return changed;
}

bool apply_to_ground(Terrain& terrain, const BrushStamp& stamp, const std::vector<Touch>& touched) {
  const bool sand = stamp.material == BrushMaterial::sand;
  const Grid<std::int32_t>& before = sand ? terrain.mobile() : terrain.bedrock();
  std::vector<std::int32_t> old(touched.size());
  std::vector<std::int32_t> wanted(touched.size());
  for (std::size_t i = 0; i < touched.size(); ++i) {
    old[i] = before[touched[i].cell];
    wanted[i] = old[i] + static_cast<std::int32_t>(std::lround(stamp.amount * touched[i].share));
    if (sand) wanted[i] = std::max(wanted[i], 0);
  }
  if (wanted == old) return false;
  const auto write = [&](const std::vector<std::int32_t>& values) {
    Grid<std::int32_t>& layer = sand ? terrain.edit_mobile() : terrain.edit_bedrock();
    for (std::size_t i = 0; i < touched.size(); ++i) layer[touched[i].cell] = values[i];
  };
  write(wanted);
  try {
    models::check_height(terrain);
  } catch (const InputError&) {
    write(old);
    throw;
  }
  return true;
}

}  // namespace

bool apply_stamp(Terrain& terrain, const BrushStamp& stamp) {
  check(stamp);
  const std::vector<Touch> touched = touches(terrain, stamp);
  return stamp.material == BrushMaterial::field ? apply_to_field(terrain, stamp, touched)
                                                : apply_to_ground(terrain, stamp, touched);
}

}  // namespace erg::session
