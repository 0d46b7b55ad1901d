#version 330 core
// What of sun, sky and wind each point of the terrain sees, from marching over the heights.
uniform sampler2D surface;
uniform vec2 texel;         // side of a texel as a share of the terrain, east and north
uniform float step_length;  // m: side of a texel
uniform float exaggeration;
uniform float highest;      // m: of the terrain, exaggerated
uniform float sun_rise;     // tangent of the lowest altitude that matters for the sun
uniform vec2 to_sun;        // unit vector on the ground
uniform vec2 to_wind;       // unit vector to where the wind blows from; zero: no wind
uniform float wind_rise;    // the same for the wind
uniform int sun_steps;      // the most that are taken
uniform int wind_steps;
uniform float stride;       // growth of the steps, as a share of the way
uniform int sky_directions;
uniform int sky_steps;
out vec4 light;  // tangent of the skyline toward the sun, share of the sky that is seen, tangent toward the wind, 0

float height_at(vec2 place) { return textureLod(surface, place, 0.0).r * exaggeration; }

// The tangent of the skyline in a direction; ends where even the highest ground would not reach `least`.
float skyline(vec2 place, float here, vec2 direction, float least, int steps) {
  float steepest = -1.0;
  float enough = (highest - here) / (least * step_length);
  float travel = 1.0;
  for (int step = 0; step < steps; ++step) {
    if (travel > enough + 2.0) break;
    float rise = height_at(place + direction * travel * texel) - here;
    steepest = max(steepest, rise / (travel * step_length));
    travel += 0.75 + travel * stride;
  }
  return steepest;
}

// Cosine squared of the horizon, the mean over all directions: an even sky over level ground.
float open_sky(vec2 place, float here) {
  float seen = 0.0;
  for (int side = 0; side < sky_directions; ++side) {
    float turn = 6.2831853 * (float(side) + 0.5) / float(sky_directions);
    vec2 direction = vec2(cos(turn), sin(turn));
    float steepest = 0.0;
    float travel = 1.5;
    for (int step = 0; step < sky_steps; ++step) {
      float rise = height_at(place + direction * travel * texel) - here;
      steepest = max(steepest, rise / (travel * step_length));
      travel *= 1.7;
    }
    seen += 1.0 / (1.0 + steepest * steepest);
  }
  return seen / float(sky_directions);
}

void main() {
  vec2 place = gl_FragCoord.xy * texel;
  float here = height_at(place);
  float sun = skyline(place, here, to_sun, sun_rise, sun_steps);
  float wind = dot(to_wind, to_wind) > 0.0 ? skyline(place, here, to_wind, wind_rise, wind_steps) : -1.0;
  light = vec4(sun, open_sky(place, here), wind, 0.0);
}
