#version 330 core
// The smooth surface: a blend of the planes around each point, in which those count that fit their own surroundings and
// agree with what lies here. Planes that straddle a brink fit nothing, so the brink stays where it is, and sharp.
#include "cells.glsl"
uniform sampler2D planes;
uniform int detail;        // texels of the target for the side of a cell
uniform int reach;         // cells: how far planes are asked
uniform float sharpness;   // 1/cells^2: how fast they count less with their distance
uniform float strictness;  // 1/m^2: and with how far they are from what lies here
out vec2 surface;          // height and thickness of the mobile layer, m

vec4 weights_at(float t) {
  float s = 1.0 - t;
  return vec4(s * s * s / 6.0, (4.0 - 3.0 * t * t * (2.0 - t)) / 6.0, (4.0 - 3.0 * s * s * (2.0 - s)) / 6.0,
              t * t * t / 6.0);
}

// Slightly smoothed cells (a cubic B-spline): a first guess that knows its place to less than a cell.
vec2 guess_at(vec2 point) {
  ivec2 base = ivec2(floor(point));
  vec2 t = point - vec2(base);
  vec4 east = weights_at(t.x), north = weights_at(t.y);
  int last = detail == 1 ? 3 : 4;  // at the very centre of a cell the fourth weighs nothing
  vec2 sum = vec2(0.0);
  for (int y = 0; y < last; ++y) {
    for (int x = 0; x < last; ++x) sum += east[x] * north[y] * cell(base + ivec2(x, y) - 1);
  }
  return sum;
}

void main() {
  vec2 point = gl_FragCoord.xy / float(detail) - 0.5;  // in cells, 0 at the centre of the first
  ivec2 home = ivec2(floor(point + 0.5));
  vec2 guess = guess_at(point);
  float weights = 1e-6, height = 0.0;
  for (int y = -reach; y <= reach; ++y) {
    int wide = int(sqrt(float(reach * reach - y * y)));
    for (int x = -wide; x <= wide; ++x) {
      ivec2 place = home + ivec2(x, y);
      vec4 there = texelFetch(planes, inside(place), 0);
      vec2 away = point - vec2(place);
      float off = there.x + dot(there.yz, away) - guess.r;
      float weight = there.w * exp(-sharpness * dot(away, away) - strictness * off * off);
      weights += weight;
      height += weight * off;
    }
  }
  height = guess.r + height / weights;
  // The layer ends where the smooth surface meets the bedrock, not in the teeth of single cells.
  surface = vec2(height, clamp(height - (guess.r - guess.g), 0.0, 2.0 * guess.g));
}
