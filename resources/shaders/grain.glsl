float grainHash(vec3 p) {
  p = fract(p * 0.3183099 + vec3(0.11, 0.23, 0.37));
  p *= 17.0;
  return fract(p.x * p.y * p.z * (p.x + p.y + p.z));
}
float grainNoise(vec3 x) {
  vec3 i = floor(x);
  vec3 f = fract(x);
  f = f * f * (3.0 - 2.0 * f);
  vec4 low = vec4(grainHash(i), grainHash(i + vec3(1, 0, 0)), grainHash(i + vec3(0, 1, 0)), grainHash(i + vec3(1, 1, 0)));
  vec4 high = vec4(grainHash(i + vec3(0, 0, 1)), grainHash(i + vec3(1, 0, 1)), grainHash(i + vec3(0, 1, 1)), grainHash(i + vec3(1, 1, 1)));
  vec4 z = mix(low, high, f.z);
  vec2 y = mix(z.xy, z.zw, f.y);
  return mix(y.x, y.y, f.x);
}
// What the light of a surface is multiplied by at a place at rest (m).
float grainTone(vec3 place, float strength) {
  float coarse = grainNoise(place * 0.9);
  float fine = grainNoise(place * 5.3);
  return 1.0 + strength * (0.42 * (coarse - 0.5) + 0.34 * (fine - 0.5));
}
