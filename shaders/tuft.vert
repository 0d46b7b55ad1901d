#version 330 core
// Tufts of plants: three crossed blades each, where the plants' cover says so.
#include "surface.glsl"
#include "noise.glsl"
uniform sampler2D plants;
uniform vec2 grid;          // columns and rows of the land
uniform int tufts_a_cell;
uniform vec2 shift;         // m: of this copy of the land
uniform float cell_side;    // m
uniform mat4 view_projection;
out float tip;   // 0 at the foot, 1 at the tip
out float tone;

void main() {
  int cell = gl_InstanceID / tufts_a_cell;
  int turn = gl_InstanceID % tufts_a_cell;
  ivec2 home = ivec2(cell % int(grid.x), cell / int(grid.x));
  vec2 seed = vec2(home) * 7.0 + vec2(turn * 131, turn * 17);
  float cover = texelFetch(plants, home, 0).r;
  vec2 place = (vec2(home) + vec2(hash(seed), hash(seed + 401.0))) / grid;
  float size = cell_side * (0.45 + 0.5 * hash(seed + 907.0)) * step(hash(seed + 1301.0), cover);
  int blade = gl_VertexID / 3;
  int corner = gl_VertexID % 3;
  float angle = 6.2831853 * (hash(seed + 77.0) + float(blade) / 5.0);
  vec2 outwards = vec2(cos(angle), sin(angle));
  vec2 aside = vec2(-outwards.y, outwards.x);
  vec3 offset = corner == 2 ? vec3(outwards * 0.5, 0.9) : vec3(aside * (corner == 0 ? -0.12 : 0.12), -0.05);
  tip = corner == 2 ? 1.0 : 0.0;
  tone = hash(seed + 55.0);
  vec3 foot = vec3(place * land + shift, surface_at(place).r * exaggeration);
  gl_Position = view_projection * vec4(foot + offset * size, 1.0);
}
