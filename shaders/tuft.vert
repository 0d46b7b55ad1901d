#version 330 core
// Tufts of plants: blades that lean out of one root, where the plants' cover says so.
#include "surface.glsl"
#include "air.glsl"
#include "noise.glsl"
layout(location = 0) in vec2 inside;  // the plants' cell, column and row of the sheet
uniform sampler2D plants;
uniform sampler2D light;    // skyline toward the sun, open sky
uniform vec2 corner;        // m: south-west corner of the sheet
uniform int tufts_a_cell;
uniform int blades;         // of a tuft
uniform vec2 shift;         // m: of this copy of the terrain
uniform mat4 view_projection;
out float tip;   // 0 at the foot, 1 at the tip
flat out float tone;
flat out vec3 shine;  // light that falls on the tuft
out vec4 haze;

void main() {
  int turn = gl_InstanceID % tufts_a_cell;
  vec2 home = inside + floor(corner / cell_side + 0.5);
  vec2 seed = home * 7.0 + vec2(turn * 131, turn * 17);
  ivec2 apron = ivec2((corner - sheet_low) / cell_side + 0.5);
  float cover = texelFetch(plants, ivec2(inside) + apron, 0).r;
  vec2 place = (home + vec2(hash(seed), hash(seed + 401.0))) * cell_side;
  float size = cell_side * (0.35 + 0.55 * hash(seed + 907.0)) * step(hash(seed + 1301.0), cover);
  int blade = gl_VertexID / 3;
  int end = gl_VertexID % 3;
  vec2 own = seed + vec2(blade * 29, blade * 53);
  float angle = 6.2831853 * (float(blade) + 0.8 * hash(own)) / float(blades);
  vec2 outwards = vec2(cos(angle), sin(angle));
  vec2 aside = vec2(-outwards.y, outwards.x);
  // The outer ones lean, those in the middle stand.
  float lean = 0.12 + 0.75 * hash(own + 77.0);
  float reach = 0.6 + 0.5 * hash(own + 211.0);
  vec3 offset = end == 2 ? reach * vec3(outwards * lean, 1.05 - 0.65 * lean * lean)
                         : vec3(outwards * 0.10 + aside * (end == 0 ? -0.05 : 0.05), -0.05);
  tip = end == 2 ? 1.0 : 0.0;
  tone = 0.6 * hash(seed + 55.0) + 0.4 * hash(own + 5.0);
  vec4 seen = textureLod(light, on_maps(place), 0.0);
  // A blade is thin: it takes the sun from wherever it stands.
  shine = 0.62 * sun_colour() * sunlit(seen.r) + 0.42 * sky_colour() * seen.g;
  vec3 foot = vec3(place + shift, surface_at(place).r * exaggeration);
  haze = haze_at(foot);
  gl_Position = view_projection * vec4(foot + offset * size, 1.0);
}
