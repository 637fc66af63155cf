// How a surface takes the light.
uniform vec3 to_light;  // unit, scene
uniform float gloss;
uniform vec2 light_strengths;  // of the light, of what comes from all sides

const vec3 sun = vec3(0.74, 0.70, 0.62);
const vec3 sky = vec3(0.47, 0.50, 0.54);
const vec3 bounce = vec3(0.40, 0.36, 0.31);

// A skin shines a little; a cut face is just moist.
float shine(vec3 n, vec3 to_eye, bool cut) {
  float spot = max(dot(n, normalize(to_light + to_eye)), 0.0);
  return cut ? 0.035 * pow(spot, 24.0) : 0.16 * pow(spot, 70.0) + 0.07 * pow(spot, 14.0);
}

// `seen`: how much of the sky and of the light reaches the place.
vec3 dull_color(vec3 color, vec3 n, vec2 seen, bool cut) {
  // Soft, wrapped light; on cut faces flatter still, so that their colours are what one sees.
  float key = clamp((dot(n, to_light) + 0.35) / 1.35, 0.0, 1.0);
  if (cut) key = mix(key, 0.8, 0.45);
  float lit = key * mix(0.12, 1.0, seen.y) * mix(0.7, 1.0, seen.x);
  vec3 ambient = light_strengths.y * mix(bounce, sky, 0.5 + 0.5 * n.y) * mix(0.2, 1.0, seen.x);
  vec3 received = ambient + light_strengths.x * lit * sun;

  // In the shade colours grow deeper, not greyer.
  float shade = clamp(1.0 - dot(received, vec3(0.33)), 0.0, 1.0);
  return pow(max(color, 1e-4), vec3(1.0 + 0.22 * shade)) * received;
}

vec3 fruit_color(vec3 color, vec3 n, vec3 to_eye, vec2 seen, bool cut) {
  return dull_color(color, n, seen, cut) + gloss * shine(n, to_eye, cut) * seen.y * vec3(1.0, 0.98, 0.94);
}
