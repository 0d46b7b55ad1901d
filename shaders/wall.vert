#version 330 core
// The cut faces of a block of land: a strip from its floor to the surface, once around.
#include "surface.glsl"
uniform int steps;       // for each side
uniform float floor_height;  // m
uniform mat4 view_projection;
out vec3 point;   // m
out vec2 section; // heights of the surface and of the bedrock here, m
out vec3 outwards;

void main() {
  int step = gl_VertexID / 2;
  int side = min(step / steps, 3);
  float along = float(step - side * steps) / float(steps);
  vec2 corners[5] = vec2[5](vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1), vec2(0, 0));
  vec2 place = mix(corners[side], corners[side + 1], along);
  vec2 run = corners[side + 1] - corners[side];
  outwards = vec3(run.y, -run.x, 0.0);
  vec2 here = surface_at(place) * exaggeration;
  section = vec2(here.r, here.r - here.g);
  point = vec3(place * land, (gl_VertexID & 1) == 0 ? floor_height : here.r);
  gl_Position = view_projection * vec4(point, 1.0);
}
