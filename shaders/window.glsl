// Light as through a window, as photographs have it (WINDOW): lit.glsl and compose.frag.glsl ask it.
uniform float juice;  // 0..1

// Light goes to and fro between surfaces of one colour, and takes more of it each time: shade keeps its colour, and
// pale things are hardly dark where they touch [Jimenez et al. 2016].
vec3 with_bounces(float seen, vec3 color) {
  vec3 a = 2.0404 * color - 0.3324, b = 0.6417 - 4.7951 * color, c = 2.7552 * color + 0.6903;
  return max(vec3(seen), ((seen * a + b) * seen + c) * seen);
}

// What a smooth surface reflects of the room: a pale wall where the window is, a dark one across, the table below.
vec3 room_at(vec3 way, vec3 to_light) {
  float towards = 0.5 + 0.5 * dot(normalize(way.xz + 1e-5), normalize(to_light.xz + 1e-5));
  vec3 wall = mix(vec3(0.10, 0.09, 0.08), vec3(0.62, 0.66, 0.70), towards * towards);
  return mix(vec3(0.34, 0.31, 0.27), wall, smoothstep(-0.15, 0.25, way.y));
}

// A second window, high up over the table: what lies flat or leans towards the eye mirrors it. With two bars.
float high_window(vec3 way, vec3 to_light) {
  vec3 towards = normalize(0.5 * to_light + vec3(0.0, 1.0, 0.0));
  vec3 right = normalize(cross(vec3(0.0, 0.0, 1.0), towards)), up = cross(towards, right);
  vec2 at = vec2(dot(way, right), dot(way, up));
  vec2 pane = smoothstep(-0.05, 0.05, vec2(0.20, 0.27) - abs(at)), bar = 1.0 - 0.5 * exp(-at * at / 0.0012);
  return dot(way, towards) > 0.0 ? pane.x * pane.y * bar.x * bar.y : 0.0;
}

// Water's share of what is reflected at this cosine [Schlick 1994].
float of_water(float cosine) {
  float c = 1.0 - clamp(cosine, 0.0, 1.0);
  return 0.02 + 0.98 * c * c * c * c * c;
}

// Bright things roll off instead of ending at white.
vec3 developed(vec3 color) {
  vec3 over = max(color - 0.72, 0.0);
  return min(color, 0.72) + 0.28 * (1.0 - exp(-over / 0.28));
}
