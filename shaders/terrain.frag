#version 330 core
// The terrain's colour: sand or snow on rock in sun and sky light (MATERIAL), or a value in the colours of a palette.
// What a picture does not need is left out of the program: GRAINS, PLANTS, TUFTS, CONTOURS, RAW_CELLS and WIRES are
// its words.
#include "sheet.glsl"
#include "air.glsl"
in vec3 point;  // m
in vec2 home;   // m: the same place of the terrain itself, not of a copy
in vec4 haze;
flat in vec3 sunshine;  // colour of the sun's light
out vec4 colour;

uniform sampler2D shape;     // height and thickness of the mobile layer (m), slope to the east and north
uniform sampler2D light;     // skyline toward the sun, open sky, skyline toward the wind
uniform sampler2D field;
uniform int source;          // of the value: 0 elevation, 1 slope, 2 field
uniform float contour_step;
const float missing = -1e37; // values below are no values

// A field's value: bilinear between its cells, unless one of them has none.
float field_at(sampler2D values, vec2 place) {
  ivec2 size = textureSize(values, 0);
  float own = texelFetch(values, clamp(ivec2(place * vec2(size)), ivec2(0), size - 1), 0).r;
#ifdef RAW_CELLS
  return own;
#else
  if (own < missing) return own;
  float blended = textureLod(values, place, 0.0).r;
  return blended < missing * 1e-6 ? own : blended;
#endif
}

float value_at(vec2 place, vec4 form) {
  if (source == 0) return form.r;
  if (source == 1) return degrees(atan(length(form.ba)));
  return field_at(field, place);
}

#ifdef MATERIAL
#include "noise.glsl"
uniform float bedrock_low;  // m: the lowest bedrock, exaggerated
uniform vec2 wind;          // unit vector to where the wind blows; zero: none
uniform float grain;        // strength of grain and ripples, 0 to 1
uniform sampler2D plants;   // share of the ground that plants cover

struct Ground {
  vec3 albedo;
  vec3 normal;
  float cover;  // share of the ground under sand or snow
};

// How large a pixel is on the ground, m.
float footprint() { return max(length(dFdx(point.xy)), length(dFdy(point.xy))); }

#ifdef GRAINS
// Wind ripples: crests across the wind, gentle to windward, wavering. Their slope along the wind.
float ripple_slope(vec2 place, float strength) {
  float length_m = 0.24 * cell_side;
  vec2 along = wind;
  vec2 aside = vec2(-along.y, along.x);
  vec2 own = vec2(dot(place, along), dot(place, aside)) / length_m;
  // The phase never runs backwards: crests bend and fork, but none is torn off.
  float wander = 1.2 * noise(own * vec2(0.06, 0.03)) + 0.25 * noise(own * vec2(0.30, 0.10) + 9.7);
  float phase = own.x + 2.0 * wander;
  float seen = 1.0 - smoothstep(0.13, 0.38, 1.3 * length(vec2(dFdx(own.x), dFdy(own.x))));
  float t = 6.2831853 * phase;
  return strength * seen * (0.7 + 0.3 * noise(own * 0.05 + 3.1)) * (cos(t) + 0.35 * cos(2.0 * t + 0.9));
}

vec2 grain_slope(vec2 place, float pixel) {
  float size = 0.16 * cell_side;
  float seen = 1.0 - smoothstep(0.3 * size, 1.2 * size, pixel);
  return 0.06 * seen * (vec2(noise(place / size), noise(place / size + 31.4)) - 0.5);
}
#endif

vec3 sand_colour(vec2 place) {
  vec3 pale = vec3(0.790, 0.500, 0.250);
  vec3 deep = vec3(0.690, 0.385, 0.160);
#ifdef GRAINS
  float large = rough_noise(place / (37.0 * cell_side));
  float small = rough_noise(place / (5.0 * cell_side) + 7.7);
  return mix(pale, deep, mix(0.45, clamp(0.75 * large + 0.35 * small - 0.1, 0.0, 1.0), grain));
#else
  return mix(pale, deep, 0.45);
#endif
}

// Desert pavement: grit with scattered stones.
vec3 bare_colour(vec2 place, float pixel, out float bumps) {
  vec3 fine = snowy ? vec3(0.250, 0.225, 0.200) : vec3(0.430, 0.300, 0.185);
  vec3 coarse = snowy ? vec3(0.350, 0.320, 0.285) : vec3(0.550, 0.400, 0.255);
  bumps = 0.0;
#ifdef GRAINS
  float patches = mix(0.5, rough_noise(place / (14.0 * cell_side)), grain);
  float grit = rough_noise(place / (0.5 * cell_side));
  float seen = grain * (1.0 - smoothstep(0.04, 0.30, pixel / cell_side));
  vec2 spot = place / (0.30 * cell_side);
  vec2 stone_at = floor(spot);
  vec2 centre = 0.3 + 0.4 * vec2(hash(stone_at), hash(stone_at + 9.0));
  float size = 0.05 + 0.22 * pow(hash(stone_at + 3.0), 4.0);
  float stone = seen * (1.0 - smoothstep(0.6 * size, size, length(spot - stone_at - centre)));
  bumps = seen * (grit - 0.5) + 0.8 * stone;
  vec3 pavement = mix(fine, coarse, 0.7 * patches + 0.3 * mix(0.5, grit, seen));
  return mix(pavement, vec3(0.24, 0.185, 0.14), 0.75 * stone);
#else
  return mix(fine, coarse, 0.5);
#endif
}

vec3 rock_colour(vec3 place) {
  vec3 dark = vec3(0.200, 0.135, 0.090);
  vec3 light = vec3(0.400, 0.290, 0.200);
#ifdef GRAINS
  float strata = noise(vec2(place.z * 1.6 / cell_side + 2.0 * rough_noise(place.xy / (9.0 * cell_side)), 3.0));
  float blotch = 0.6 * rough_noise(place.xy / (5.0 * cell_side)) + 0.4 * rough_noise(place.xy / (0.9 * cell_side));
  return mix(dark, light, mix(0.5, 0.5 * strata + 0.5 * blotch, grain));
#else
  return mix(dark, light, 0.5);
#endif
}

Ground ground_at(vec4 form, vec4 seen) {
  vec2 slope = form.ba * exaggeration;
  float pixel = footprint();
  float steep = length(slope);
  // Nothing loose lies on a cliff.
  float covered = (1.0 - exp(-max(form.g, 0.0) / (0.22 * cell_side))) * (1.0 - smoothstep(1.15, 1.6, steep / exaggeration));
  float bumps = 0.0;
  vec3 bare = vec3(0.0);
  float rocky = smoothstep(0.2, 1.2, (point.z - form.g * exaggeration - bedrock_low) / cell_side);
  if (covered < 0.995) bare = bare_colour(home, pixel, bumps);
  if (covered < 0.995 && rocky > 0.0) bare = mix(bare, rock_colour(vec3(home, point.z)), rocky);
  float open = (1.0 - smoothstep(0.40, 0.55, steep)) * (1.0 - smoothstep(0.10, 0.24, seen.b)) * covered;
#ifdef GRAINS
  vec2 fine = grain_slope(home, pixel) * (0.4 + 0.6 * open);
  if (wind != vec2(0.0)) fine += wind * ripple_slope(home, 0.20 * open);
  if (rocky > 0.0 && covered < 0.995) {
    vec2 rough = vec2(rough_noise(home / (1.7 * cell_side)), rough_noise(home / (1.7 * cell_side) + 77.0)) - 0.5;
    fine += 1.1 * (1.0 - covered) * rocky * rough;
  }
  slope += grain * (fine + vec2(bumps * (1.0 - covered) * 0.25));
#endif
  vec3 cover = snowy ? vec3(0.90, 0.91, 0.93) : sand_colour(home);
  return Ground(mix(bare, cover, covered), normalize(vec3(-slope, 1.0)), covered);
}

#ifdef PLANTS
// Litter under the tufts; where these are too small to be seen or not drawn, their colour instead.
vec3 planted(vec3 albedo, float cover) {
#ifdef TUFTS
  bool beyond = any(lessThan(point.xy, -terrain)) || any(greaterThan(point.xy, 2.0 * terrain));
  float far = beyond ? 1.0 : smoothstep(0.15, 0.70, footprint() / cell_side);
#else
  const float far = 1.0;
#endif
  float bare = (1.0 - cover) * (1.0 - cover);
  return mix(albedo, mix(vec3(0.140, 0.120, 0.060), vec3(0.115, 0.118, 0.048), far),
             mix(0.70 * cover, 0.92 * (1.0 - bare * bare), far));
}
#endif

vec3 lit(Ground ground, vec4 seen) {
  float facing = max(dot(ground.normal, to_sun), 0.0);
  float sun = facing * sunlit(seen.r) / mix(1.0, max(to_sun.z, 0.15), 0.55);
  float open = seen.g * seen.g * (0.6 + 0.4 * ground.normal.z);
  vec3 bounced = ground.albedo * sunshine * ((snowy ? 0.03 : 0.10) + 0.35 * (1.0 - seen.g));
  vec3 sun_light = sunshine * 0.86 * sun;
  vec3 sky_light = sky_colour() * (snowy ? 0.38 : 0.235) * open;
  vec3 result = ground.albedo * (sun_light + sky_light + bounced);
#ifdef GRAINS
  if (snowy) {
    // Single crystals that happen to face between sun and eye.
    vec2 crystal = floor(home / (0.03 * cell_side));
    float near = 1.0 - smoothstep(0.02, 0.10, footprint() / cell_side);
    result += near * ground.cover * sun_light * 1.5 * step(0.9965, hash(crystal));
  }
#endif
  if (!snowy) {
    // Grains throw light back the way it came and forward at a glance, which softens dunes towards the sun.
    vec3 to_eye = normalize(eye - point);
    float glance = 1.0 - max(dot(ground.normal, to_eye), 0.0);
    glance *= glance * glance * glance;
    result += ground.albedo * sun_light * 0.22 * glance * max(dot(-to_eye.xy, to_sun.xy), 0.0);
  }
  return result;
}

vec3 shown_at(vec2 place, vec4 form, vec4 seen, float value) {
  Ground ground = ground_at(form, seen);
#ifdef PLANTS
  ground.albedo = planted(ground.albedo, clamp(field_at(plants, place), 0.0, 1.0));
#endif
#ifdef RAW_CELLS
  ground.normal = normalize(cross(dFdx(point), dFdy(point)));
#endif
  return lit(ground, seen);
}
#else
uniform bool shading;  // values are shaded by the light
uniform vec2 range;    // values at the ends of the palette
uniform vec3 palette[32];
uniform int palette_size;

vec3 palette_at(float t) {
  float position = clamp(t, 0.0, 1.0) * float(palette_size - 1);
  int below = min(int(position), palette_size - 2);
  return mix(palette[below], palette[below + 1], position - float(below));
}

vec3 shown_at(vec2 place, vec4 form, vec4 seen, float value) {
#ifdef RAW_CELLS
  vec3 normal = normalize(cross(dFdx(point), dFdy(point)));
#else
  vec3 normal = normalize(vec3(-form.ba * exaggeration, 1.0));
#endif
  if (value < missing) return to_linear(vec3(1.0, 0.0, 0.933));
  float relief = max(dot(normal, to_sun) / max(to_sun.z, 0.15), 0.0);
  float brightness = 0.30 + 0.50 * relief * (0.35 + 0.65 * sunlit(seen.r)) + 0.25 * seen.g;
  vec3 tint = to_linear(palette_at((value - range.x) / max(range.y - range.x, 1e-20)));
  return tint * (shading ? clamp(brightness, 0.0, 1.12) : 1.0);
}
#endif

#ifdef CONTOURS
// Lines where the value is a multiple of the step, about a pixel and a half wide.
float contour(float value) {
  float lines = value / contour_step;
  float width = fwidth(lines);
  float from_line = abs(fract(lines + 0.5) - 0.5) / max(width, 1e-6);
  float level = smoothstep(0.0005, 0.002, width);  // on level ground a line would be a blot
  return level * (1.0 - smoothstep(0.5, 1.3, from_line)) * (1.0 - smoothstep(0.25, 0.6, width));
}
#endif

void main() {
#ifdef WIRES
  colour = vec4(to_srgb(vec3(0.02, 0.015, 0.01)), 1.0);
#else
  vec2 place = on_maps(home);
  vec4 form = textureLod(shape, place, 0.0);
  vec4 seen = textureLod(light, place, 0.0);
  float value = value_at(place, form);
  vec3 shown = shown_at(place, form, seen, value);
#ifdef CONTOURS
  if (value > missing) shown = mix(shown, vec3(0.02, 0.015, 0.01), 0.7 * contour(value));
#endif
#ifdef MATERIAL
  shown = film(mix(haze.rgb, shown, haze.a));
#endif
  colour = vec4(to_srgb(shown), 1.0);
#endif
}
