#version 330 core
// A cut face of a block of terrain: a strip from its floor to the surface.
#include "surface.glsl"
uniform int steps;       // along the face
uniform vec2 from, to;   // m: its ends, anticlockwise around the terrain
uniform float floor_height;  // m
uniform mat4 view_projection;
out vec3 point;   // m
out vec2 section; // heights of the surface and of the bedrock here, m
out vec3 outwards;

void main() {
  vec2 metres = mix(from, to, float(gl_VertexID / 2) / float(steps));
  vec2 run = normalize(to - from);
  outwards = vec3(run.y, -run.x, 0.0);
  vec2 here = surface_at(metres) * exaggeration;
  section = vec2(here.r, here.r - here.g);
  point = vec3(metres, (gl_VertexID & 1) == 0 ? floor_height : here.r);
  gl_Position = view_projection * vec4(point, 1.0);
}
