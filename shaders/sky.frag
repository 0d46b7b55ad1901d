#version 330 core
// Behind the terrain: the sky and the far plain, or an even backdrop.
#include "air.glsl"
uniform vec2 picture;        // pixels
uniform vec3 right, up, ahead;  // of the view; right and up as long as half the picture at distance 1
uniform vec3 plain;          // colour of the terrain at large, linear
uniform float plain_height;  // m
out vec4 colour;

void main() {
  vec2 place = gl_FragCoord.xy / picture * 2.0 - 1.0;
#ifdef BACKDROP
  // No sky: the terrain stands free before a calm ground.
  float centre = length(place * vec2(0.7, 0.9) - vec2(0.0, 0.1));
  colour = vec4(mix(vec3(0.925, 0.915, 0.90), vec3(0.70, 0.69, 0.68), smoothstep(0.1, 1.3, centre)), 1.0);
#else
  vec3 direction = normalize(ahead + place.x * right + place.y * up);
  vec3 shown = sky(direction);
  if (direction.z < 0.0) {
    vec3 point = eye + direction * (eye.z - plain_height) / max(-direction.z, 1e-4);
    vec4 haze = haze_at(point);
    shown = mix(haze.rgb, plain, haze.a);
  }
  colour = vec4(to_srgb(film(shown)), 1.0);
#endif
}
