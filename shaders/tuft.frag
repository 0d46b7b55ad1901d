#version 330 core
#include "air.glsl"
in float tip;
in float tone;
out vec4 colour;
void main() {
  vec3 green = mix(vec3(0.055, 0.085, 0.025), vec3(0.20, 0.235, 0.075), 0.65 * tip + 0.35 * tone);
  colour = vec4(to_srgb(green * (0.5 + 0.6 * to_sun.z)), 1.0);
}
