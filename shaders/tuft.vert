#version 330 core
// Tufts of plants: five blades each, where the plants' cover says so.
#include "surface.glsl"
#include "noise.glsl"
layout(location = 0) in vec2 inside;  // the plants' cell, column and row of the sheet
uniform sampler2D plants;
uniform vec2 corner;        // m: south-west corner of the sheet
uniform int tufts_a_cell;
uniform vec2 shift;         // m: of this copy of the land
uniform mat4 view_projection;
out float tip;   // 0 at the foot, 1 at the tip
out float tone;

void main() {
  int turn = gl_InstanceID % tufts_a_cell;
  vec2 home = inside + floor(corner / cell_side + 0.5);
  vec2 seed = home * 7.0 + vec2(turn * 131, turn * 17);
  ivec2 apron = ivec2((corner - sheet_low) / cell_side + 0.5);
  float cover = texelFetch(plants, ivec2(inside) + apron, 0).r;
  vec2 place = (home + vec2(hash(seed), hash(seed + 401.0))) * cell_side;
  float size = cell_side * (0.45 + 0.5 * hash(seed + 907.0)) * step(hash(seed + 1301.0), cover);
  int blade = gl_VertexID / 3;
  int end = gl_VertexID % 3;
  float angle = 6.2831853 * (hash(seed + 77.0) + float(blade) / 5.0);
  vec2 outwards = vec2(cos(angle), sin(angle));
  vec2 aside = vec2(-outwards.y, outwards.x);
  vec3 offset = end == 2 ? vec3(outwards * 0.5, 0.9) : vec3(aside * (end == 0 ? -0.12 : 0.12), -0.05);
  tip = end == 2 ? 1.0 : 0.0;
  tone = hash(seed + 55.0);
  vec3 foot = vec3(place + shift, surface_at(place).r * exaggeration);
  gl_Position = view_projection * vec4(foot + offset * size, 1.0);
}
