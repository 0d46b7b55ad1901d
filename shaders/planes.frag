#version 330 core
// The plane that fits the surface best around each cell, and how badly it fits: whole slabs are steps of counting, not
// of the ground, and a plane over some dozens of cells does not see them.
#include "cells.glsl"
out vec4 plane;  // height at the cell (m), slope to the east and north (m a cell), mean square of the misfit (m^2)

uniform int reach;  // cells: radius of the plane

void main() {
  ivec2 home = ivec2(gl_FragCoord.xy);
  float level = cell(home).r;
  float count = 0.0, square = 0.0, sum = 0.0, sum_square = 0.0;
  vec2 moment = vec2(0.0);
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (x * x + y * y > reach * reach + 1) continue;
      float height = cell(home + ivec2(x, y)).r - level;
      count += 1.0;
      square += float(x * x);
      sum += height;
      sum_square += height * height;
      moment += vec2(x, y) * height;
    }
  }
  vec2 slope = moment / square;
  float mean = sum / count;
  float misfit = sum_square / count - mean * mean - dot(slope, slope) * square / count;
  plane = vec4(level + mean, slope, max(misfit, 0.0));
}
