#version 330 core
// A section through sand and rock.
#include "air.glsl"
#include "noise.glsl"
in vec3 point;
in vec2 section;
in vec3 outwards;
out vec4 colour;
uniform float cell_side;  // m

void main() {
  float depth = (section.x - point.z) / cell_side;
  bool sand = point.z > section.y;
  float layers = noise(vec2((depth + 0.15 * noise(point.xy / (8.0 * cell_side))) * 2.6, 1.0));
  vec3 cover = snowy ? vec3(0.72, 0.78, 0.86) : mix(vec3(0.50, 0.33, 0.18), vec3(0.58, 0.40, 0.235), layers);
  vec3 rock = vec3(0.165, 0.145, 0.13) * (0.9 + 0.2 * noise(vec2(point.z / cell_side * 0.8, 5.0)));
  vec3 shown = (sand ? cover : rock) * (0.42 + 0.4 * max(dot(outwards, to_sun), 0.0));
  colour = vec4(to_srgb(film(shown)), 1.0);
}
