// The smooth surface at any point, by cubic B-splines (four bilinear reads each, Sigg & Hadwiger 2005).
#include "sheet.glsl"
uniform sampler2D surface;    // height and thickness of the mobile layer, m
uniform vec2 surface_texels;  // columns and rows of it

void spline_value(float t, out vec2 weight, out vec2 place) {
  float s = 1.0 - t;
  float w0 = s * s * s / 6.0;
  float w1 = (4.0 - 3.0 * t * t * (2.0 - t)) / 6.0;
  float w2 = (4.0 - 3.0 * s * s * (2.0 - s)) / 6.0;
  float w3 = t * t * t / 6.0;
  weight = vec2(w0 + w1, w2 + w3);
  place = vec2(w1 / weight.x - 1.0, w3 / weight.y + 1.0);
}

vec2 blend_reads(vec2 base, vec2 weight_x, vec2 place_x, vec2 weight_y, vec2 place_y) {
  vec2 low = (base + vec2(place_x.x, place_y.x) + 0.5) / surface_texels;
  vec2 high = (base + vec2(place_x.y, place_y.y) + 0.5) / surface_texels;
  return weight_y.x * (weight_x.x * textureLod(surface, low, 0.0).rg +
                       weight_x.y * textureLod(surface, vec2(high.x, low.y), 0.0).rg) +
         weight_y.y * (weight_x.x * textureLod(surface, vec2(low.x, high.y), 0.0).rg +
                       weight_x.y * textureLod(surface, high, 0.0).rg);
}

// Height and sand at a place of the terrain, m.
vec2 surface_at(vec2 metres) {
  vec2 place = on_maps(metres);
  if (raw_cells) return textureLod(surface, place, 0.0).rg;
  vec2 point = place * surface_texels - 0.5;
  vec2 base = floor(point);
  vec2 weight_x, place_x, weight_y, place_y;
  spline_value(point.x - base.x, weight_x, place_x);
  spline_value(point.y - base.y, weight_y, place_y);
  return blend_reads(base, weight_x, place_x, weight_y, place_y);
}
