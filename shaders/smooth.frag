#version 330 core
// The smooth surface: a blend of the planes around each point, in which those count that fit their own surroundings and
// agree with what lies here. Planes that straddle a brink fit nothing, so the brink stays where it is, and sharp.
#include "cells.glsl"
uniform sampler2D planes;
uniform int detail;       // texels of the target for the side of a cell
uniform int reach;        // cells: how far planes are asked
uniform float spread;     // cells: how far they count
uniform float noise;      // m: misfit of a plane that fits
uniform float tolerance;  // m: how far a plane may be from what lies here
out vec2 surface;         // height and thickness of the mobile layer, m

vec4 plane(ivec2 place) {
  place = periodic ? place - extent * ivec2(floor(vec2(place) / vec2(extent))) : clamp(place, ivec2(0), extent - 1);
  return texelFetch(planes, place, 0);
}

// Slightly smoothed cells (a cubic B-spline): a first guess that knows its place to less than a cell.
vec2 guess_at(vec2 point) {
  vec2 base = floor(point);
  vec2 t = point - base;
  vec2 s = 1.0 - t;
  vec2 weight[4] = vec2[4](s * s * s / 6.0, (4.0 - 3.0 * t * t * (2.0 - t)) / 6.0, (4.0 - 3.0 * s * s * (2.0 - s)) / 6.0,
                           t * t * t / 6.0);
  vec2 sum = vec2(0.0);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 4; ++x) sum += weight[x].x * weight[y].y * cell(ivec2(base) + ivec2(x, y) - 1);
  }
  return sum;
}

void main() {
  vec2 point = gl_FragCoord.xy / float(detail) - 0.5;  // in cells, 0 at the centre of the first
  ivec2 home = ivec2(floor(point + 0.5));
  vec2 guess = guess_at(point);
  float weights = 1e-6, height = 1e-6 * guess.r;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (x * x + y * y > reach * reach) continue;
      ivec2 place = home + ivec2(x, y);
      vec4 there = plane(place);
      vec2 away = point - vec2(place);
      float value = there.x + dot(there.yz, away);
      float fit = noise * noise / (noise * noise + there.w);
      float near = exp(-dot(away, away) / (2.0 * spread * spread));
      float wrong = value - guess.r;
      float weight = near * fit * fit * fit * fit * exp(-wrong * wrong / (2.0 * tolerance * tolerance));
      weights += weight;
      height += weight * value;
    }
  }
  height /= weights;
  // The layer ends where the smooth surface meets the bedrock, not in the teeth of single cells.
  surface = vec2(height, clamp(height - (guess.r - guess.g), 0.0, 2.0 * guess.g));
}
