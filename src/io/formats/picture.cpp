#include "io/formats/picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/errors.h"
#include "io/formats/legend.h"
#include "io/formats/relief.h"
#include "picture/palette.h"

namespace erg::io {

using picture::blend;
using picture::Colour;
using picture::find_palette;
using picture::Palette;
using picture::RgbImage;

namespace {

constexpr Colour bare_ground{0.54f, 0.49f, 0.43f};
constexpr Colour rock{0.50f, 0.50f, 0.51f};
constexpr Colour sunlight{1.00f, 0.965f, 0.90f};
constexpr Colour skylight{0.80f, 0.90f, 1.00f};
constexpr double sky_share = 0.31;  // of the light on open level ground

// The range of heights that the palette spans: without the highest and lowest two hundredths, which would pale the
// rest.
struct Range {
  float low = 0;
  float high = 1;
  double share(float value) const { return high > low ? (value - low) / (high - low) : 0.5; }
};

Range usual_range(const Grid<float>& values) {
  std::vector<float> sorted(values.cells().begin(), values.cells().end());
  const auto rank = [&sorted](double share) {
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), sorted.begin() + place, sorted.end());
    return sorted[static_cast<std::size_t>(place)];
  };
  return {rank(0.02), rank(0.98)};
}

// A declared field brought to the pixels.
struct Overlay {
  const Field* field = nullptr;
  const Palette* palette = nullptr;
  Grid<float> values;
};

Overlay make_overlay(const Terrain& terrain, const MapScale& scale, const std::string& key) {
  if (key.empty()) return {};
  std::vector<std::string> keys;
  for (const Field& field : terrain.fields()) {
    keys.push_back(field.info.key);
    if (field.info.key != key) continue;
    const bool periodic = terrain.boundary() == Boundary::torus;
    const Grid<float> values = nearest_blocks(field.values, scale.blocks);
    return {&field, &find_palette(field.info.palette), smooth_enlarge(values, 0.5, scale.zoom, periodic)};
  }
  throw InputError("field", "this run has no field " + quote(key),
                   keys.empty() ? "its model declares none" : suggestion(key, keys));
}

// What the ground is made of at a pixel.
Colour ground_colour(const Relief& relief, const Palette& palette, const Range& range, std::size_t pixel) {
  const double rocky = std::clamp(relief.bedrock[pixel] / (2 * relief.pixel_size), 0.0, 1.0);
  const Colour bare = blend(bare_ground, rock, rocky);
  const double covered = 1 - std::exp(-std::max(0.0f, relief.sand[pixel]) / 0.6);
  return blend(bare, palette.at(range.share(relief.surface[pixel])), covered);
}

// Colours are squared to add light (close to linear light) and rooted again.
Colour lit(Colour ground, double sun, double sky) {
  const auto channel = [&](float albedo, float sunny, float skyey) {
    const double light = (1 - sky_share) * sun * sunny + sky_share * sky * skyey;
    const double value = albedo * albedo * light;
    const double shoulder = value < 0.8 ? value : 0.8 + 0.2 * std::tanh((value - 0.8) / 0.2);  // no burnt-out slopes
    return static_cast<float>(std::sqrt(shoulder));
  };
  return {channel(ground.red, sunlight.red, skylight.red), channel(ground.green, sunlight.green, skylight.green),
          channel(ground.blue, sunlight.blue, skylight.blue)};
}

RgbImage draw_map(const Terrain& terrain, const MapScale& scale, const Relief& relief, const PictureOptions& options) {
  const Palette& palette = find_palette(options.palette);
  const Overlay overlay = make_overlay(terrain, scale, options.field);
  const Light light = light_up(relief, {options.sun_bearing, options.sun_altitude});
  const Range range = usual_range(relief.surface);
  RgbImage map(relief.extent().nx, relief.extent().ny);
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      const std::size_t pixel = relief.surface.index(x, map.height - 1 - y);
      Colour ground = ground_colour(relief, palette, range, pixel);
      if (overlay.field != nullptr) {
        const FieldInfo& info = overlay.field->info;
        ground = overlay.palette->at((overlay.values[pixel] - info.minimum) / (info.maximum - info.minimum));
      }
      map.set(x, y, lit(ground, light.sun[pixel], light.sky[pixel]));
    }
  }
  return map;
}

}  // namespace

RgbImage draw_picture(const Terrain& terrain, const PictureOptions& options) {
  check_whole(terrain);
  if (terrain.extent().cells() == 0) return {};
  const MapScale scale = map_scale(terrain.extent(), options.pixels);
  const Relief relief = make_relief(terrain, scale);
  RgbImage map = draw_map(terrain, scale, relief, options);
  if (!options.legend) return map;
  RgbImage whole(std::max(map.width, smallest_legend), map.height + legend_height, {1, 1, 1});
  whole.paste(map, (whole.width - map.width) / 2, 0);
  draw_legend(whole, relief.pixel_size, options);
  return whole;
}

}  // namespace erg::io
