#include "render/look.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.h"
#include "core/surface_range.h"
#include "picture/annotations.h"

namespace erg::render {

using picture::find_palette;
using picture::number_text;

namespace {

void check_number(const std::string& name, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw InputError(name, "is " + number_text(value), "expected " + number_text(least) + " to " + number_text(most));
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

ValueScale scale(std::string label, std::string unit, Range range, const std::string& palette) {
  if (!(range.low <= range.high)) range = {0, 1};
  return {std::move(label), std::move(unit), range.low, range.high, find_palette(palette)};
}

}  // namespace

const std::vector<std::string>& standard_looks() {
  static const std::vector<std::string> looks{"material", "sand", "snow", "elevation", "slope"};
  return looks;
}

void check_look(const Look& look, const TerrainView& view) {
  std::vector<std::string> known = standard_looks();
  const std::vector<std::string> keys = view.field_keys();
  known.insert(known.end(), keys.begin(), keys.end());
  if (std::find(known.begin(), known.end(), look.show) == known.end()) {
    throw InputError("look", "there is no look " + quote(look.show), suggestion(look.show, known));
  }
  if (!look.palette.empty()) find_palette(look.palette);
  check_number("exaggeration", look.exaggeration, 0.01, 100);
  check_number("sun altitude", look.sun_altitude, 1, 90);
  check_number("sun bearing", look.sun_bearing, -360, 360);
  check_number("contours", look.contours, 0, 1e9);
  check_number("copies", look.copies, 0, 8);
  check_number("grain", look.grain, 0, 1);
}

ValueScale value_scale(const Look& look, const TerrainView& view) {
  const auto palette = [&](const std::string& own) { return look.palette.empty() ? own : look.palette; };
  if (look.show == "slope") return scale("slope", "deg", {0, 45}, palette("batlow"));
  const Field* const field = view.find_field(look.show);
  if (field == nullptr || look.is_material()) {
    const SurfaceRange range = surface_range(*view.terrain);
    const Range metres{view.terrain->metres(range.low), view.terrain->metres(range.high)};
    return scale("height", "m", metres, palette("RdYlGn"));
  }
  Range range;
  for (const float value : field->values.cells()) range.take(value);
  if (!(range.low <= range.high)) range = {field->info.minimum, field->info.maximum};
  return scale(field->info.label, field->info.unit, range, palette(field->info.palette));
}

}  // namespace erg::render
