// Repeatable noise over the terrain.
float hash(vec2 cell) {
  uvec2 bits = uvec2(ivec2(cell)) * uvec2(1597334673u, 3812015801u);
  uint mixed = (bits.x ^ bits.y) * 1597334673u;
  mixed ^= mixed >> 15;
  mixed *= 2246822519u;
  mixed ^= mixed >> 13;
  return float(mixed >> 8) / 16777216.0;
}

// Smooth noise from 0 to 1 with one bump a unit.
float noise(vec2 place) {
  vec2 base = floor(place);
  vec2 t = place - base;
  t = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  float low = mix(hash(base), hash(base + vec2(1, 0)), t.x);
  float high = mix(hash(base + vec2(0, 1)), hash(base + vec2(1, 1)), t.x);
  return mix(low, high, t.y);
}

// Noise of several sizes, 0 to 1.
float rough_noise(vec2 place) {
  return 0.5 * noise(place) + 0.27 * noise(place * 2.13 + 17.3) + 0.15 * noise(place * 4.71 + 5.1) +
         0.08 * noise(place * 9.87 + 41.7);
}
