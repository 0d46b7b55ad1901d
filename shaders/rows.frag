#version 330 core
// Sums along a row of cells: the first half of fitting a plane to a square of them (planes.frag).
#include "cells.glsl"
uniform int reach;  // cells: half the side of the square
out vec4 sums;      // height of the cell (m); around it, above that height: sum, moment to the east, sum of squares

void main() {
  ivec2 home = ivec2(gl_FragCoord.xy);
  float level = cell(home).r;
  vec3 sum = vec3(0.0);
  for (int x = -reach; x <= reach; ++x) {
    float height = cell(home + ivec2(x, 0)).r - level;
    sum += height * vec3(1.0, float(x), height);
  }
  sums = vec4(level, sum);
}
