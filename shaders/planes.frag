#version 330 core
// The plane that fits the surface best around each cell, and how well it fits: whole slabs are steps of counting, not of
// the ground, and a plane over some dozens of cells does not see them.
#include "cells.glsl"
uniform int reach;    // cells: half the side of the square that the plane is fitted to
uniform float noise;  // m: misfit of a plane that fits
out vec4 plane;       // height at the cell (m), slope to the east and north (m a cell), how far to trust it (0 to 1)

void main() {
  ivec2 home = ivec2(gl_FragCoord.xy);
  float side = float(2 * reach + 1);
  float level = cell4(home).x;
  float sum = 0.0, sum_square = 0.0;
  vec2 moment = vec2(0.0);
  for (int y = -reach; y <= reach; ++y) {
    vec4 row = cell4(home + ivec2(0, y));
    float above = row.x - level;  // the sums of the row count from its own middle
    float here = row.y + side * above;
    sum += here;
    moment += vec2(row.z, float(y) * here);
    sum_square += row.w + above * (2.0 * row.y + side * above);
  }
  float count = side * side;
  float square = side * float(reach * (reach + 1)) * side / 3.0;  // of the distances east, or north, from the middle
  vec2 slope = moment / square;
  float mean = sum / count;
  float misfit = max(sum_square / count - mean * mean - dot(slope, slope) * square / count, 0.0);
  float fit = noise * noise / (noise * noise + misfit);
  fit *= fit;
  plane = vec4(level + mean, slope, fit * fit);
}
