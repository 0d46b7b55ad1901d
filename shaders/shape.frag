#version 330 core
// The surface as every pixel of a picture reads it: a cubic B-spline with its slopes, at the knots.
#include "cells.glsl"
uniform float texel_side;  // m
uniform bool raw_cells;    // heights as they are
out vec4 shape;            // height and thickness of the mobile layer (m), slope to the east and north

void main() {
  ivec2 home = ivec2(gl_FragCoord.xy);
  float value[3] = float[3](1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0);
  vec2 mean = vec2(0.0), slope = vec2(0.0);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 3; ++x) {
      vec2 there = cell(home + ivec2(x - 1, y - 1));
      mean += value[x] * value[y] * there;
      slope += there.r * vec2(float(x - 1) * value[y], value[x] * float(y - 1));
    }
  }
  shape = vec4(raw_cells ? cell(home) : mean, 0.5 * slope / texel_side);
}
