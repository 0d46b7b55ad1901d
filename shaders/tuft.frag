#version 330 core
#include "air.glsl"
in float tip;
flat in float tone;
flat in vec3 shine;
in vec4 haze;
out vec4 colour;
void main() {
  // Grey-green to straw, dark between the blades' feet.
  vec3 blade = mix(vec3(0.135, 0.165, 0.060), vec3(0.330, 0.300, 0.130), tone * tone);
  vec3 shown = blade * shine * mix(0.35, 1.35, tip);
  colour = vec4(to_srgb(film(mix(haze.rgb, shown, haze.a))), 1.0);
}
