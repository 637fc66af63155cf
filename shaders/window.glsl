// Light through a window, as in photographs (WINDOW), for lit.glsl and compose.frag.glsl.
uniform float juice;  // 0..1

// Interreflection between surfaces of one colour deepens that colour: shade keeps its colour, and pale things are
// hardly dark where they touch [Jimenez et al. 2016].
vec3 with_bounces(float seen, vec3 color) {
  vec3 a = 2.0404 * color - 0.3324, b = 0.6417 - 4.7951 * color, c = 2.7552 * color + 0.6903;
  return max(vec3(seen), ((seen * a + b) * seen + c) * seen);
}

// The room that a smooth surface reflects: a pale wall on the window's side, a dark one opposite, the table below.
vec3 room_at(vec3 way, vec3 to_light) {
  float towards = 0.5 + 0.5 * dot(normalize(way.xz + 1e-5), normalize(to_light.xz + 1e-5));
  vec3 wall = mix(vec3(0.10, 0.09, 0.08), vec3(0.62, 0.66, 0.70), towards * towards);
  return mix(vec3(0.34, 0.31, 0.27), wall, smoothstep(-0.15, 0.25, way.y));
}

// A second window with two bars, high over the table: surfaces that lie flat or lean towards the eye reflect it.
float high_window(vec3 way, vec3 to_light) {
  vec3 towards = normalize(0.5 * to_light + vec3(0.0, 1.0, 0.0));
  vec3 right = normalize(cross(vec3(0.0, 0.0, 1.0), towards)), up = cross(towards, right);
  vec2 at = vec2(dot(way, right), dot(way, up));
  vec2 pane = smoothstep(-0.05, 0.05, vec2(0.20, 0.27) - abs(at)), bar = 1.0 - 0.5 * exp(-at * at / 0.0012);
  return dot(way, towards) > 0.0 ? pane.x * pane.y * bar.x * bar.y : 0.0;
}

// The reflectance of water at this cosine [Schlick 1994].
float of_water(float cosine) {
  float c = 1.0 - clamp(cosine, 0.0, 1.0);
  return 0.02 + 0.98 * c * c * c * c * c;
}

// Bright values roll off instead of clipping at white.
vec3 developed(vec3 color) {
  vec3 over = max(color - 0.72, 0.0);
  return min(color, 0.72) + 0.28 * (1.0 - exp(-over / 0.28));
}
