// Sun, sky and haze, in linear light; flat open ground in full sun is about as bright as its own colour.
uniform vec3 to_sun;      // unit vector
uniform vec3 eye;         // m
uniform float haze_depth; // m over which haze takes most of the contrast; 0: clear air
uniform bool snowy;

vec3 to_linear(vec3 srgb) { return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), step(0.04045, srgb)); }
vec3 to_srgb(vec3 linear) {
  linear = clamp(linear, 0.0, 1.0);
  return mix(linear * 12.92, 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, linear));
}

// Low suns are warmer.
vec3 sun_colour() {
  float low = exp(-to_sun.z * 4.0);
  return mix(vec3(1.0, 0.95, 0.87), vec3(1.0, 0.72, 0.45), low);
}
// The part of the sun that stands above the skyline.
float sunlit(float skyline) {
  float sun = to_sun.z / max(length(to_sun.xy), 1e-3);
  float width = 0.02 + 0.03 * sun;
  return smoothstep(-width, width, sun - skyline);
}

vec3 sky_colour() { return snowy ? vec3(0.44, 0.63, 1.0) : vec3(0.55, 0.70, 1.0); }

// The sky in a direction: blue above, pale at the horizon, warm around the sun.
vec3 sky(vec3 direction) {
  float height = max(direction.z, 0.0);
  vec3 zenith = vec3(0.08, 0.21, 0.50);
  vec3 middle = vec3(0.27, 0.47, 0.76);
  vec3 rim = snowy ? vec3(0.76, 0.84, 0.94) : vec3(0.80, 0.75, 0.67);
  vec3 colour = mix(rim, middle, 1.0 - exp(-height * 13.0));
  colour = mix(colour, zenith, 1.0 - exp(-height * 2.2));
  float near_sun = max(dot(direction, to_sun), 0.0);
  colour += sun_colour() * (0.22 * pow(near_sun, 10.0) + 0.35 * pow(near_sun, 160.0));
  return colour;
}

// The haze before a point: its colour, and what it leaves of what lies behind.
vec4 haze_at(vec3 point) {
  if (haze_depth <= 0.0) return vec4(0.0, 0.0, 0.0, 1.0);
  vec3 away = point - eye;
  float path = length(away) / haze_depth;
  return vec4(sky(vec3(normalize(away.xy), 0.0)), exp(-path * path * path));
}

// Rolls bright colours off softly.
vec3 film(vec3 colour) {
  colour *= 1.18;
  vec3 over = max(colour - 0.6, 0.0);
  return min(colour, 0.6) + 0.4 * (1.0 - exp(-over / 0.4));
}
