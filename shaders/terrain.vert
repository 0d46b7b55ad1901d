#version 330 core
// A tile of the terrain: a square of strips whose height comes from a texture.
#include "surface.glsl"
#include "air.glsl"
layout(location = 0) in vec2 origin;   // the tile's south-west corner, cells
layout(location = 1) in vec4 strides;  // steps of the coarser neighbours in the west, east, south, north, in own steps
uniform int quads;                     // steps for the side of the tile
uniform float tile_cells;              // side of the tile, cells
uniform vec2 grid;                     // columns and rows of the sheet, without its apron
uniform vec2 corner;                   // m: its south-west corner
uniform vec2 shift;                    // m: of the copy of the terrain that is drawn
uniform mat4 view_projection;
out vec3 point;  // m
out vec2 home;   // m: the same place of the terrain itself, not of a copy
out vec4 haze;   // its colour, and what it leaves of others
flat out vec3 sunshine;  // colour of the sun's light

float snap(float step, float stride) { return floor(step / stride) * stride; }

void main() {
  vec2 step = vec2(gl_VertexID % (quads + 1), gl_VertexID / (quads + 1));
  // At an edge beside a coarser tile only its corners are used, so that no gap opens.
  if (step.x == 0.0) step.y = snap(step.y, strides.x);
  if (step.x == float(quads)) step.y = snap(step.y, strides.y);
  if (step.y == 0.0) step.x = snap(step.x, strides.z);
  if (step.y == float(quads)) step.x = snap(step.x, strides.w);
  vec2 copy = floor((origin + 0.5) / grid);
  vec2 inside = min(origin - copy * grid + step * tile_cells / float(quads), grid);
  home = min(corner + inside * cell_side, terrain) + (raw_cells ? 0.5 * cell_side : 0.0);
  point = vec3(home + copy * terrain + shift, surface_at(home).r * exaggeration);
  haze = haze_at(point);
  sunshine = sun_colour();
  gl_Position = view_projection * vec4(point, 1.0);
}
