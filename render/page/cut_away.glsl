// What knives remove from a piece.
uniform vec4 knife_plane[4], knife_along[4];
uniform int knives;  // their number: loops end there, also on software renderers
uniform vec4 keep;   // +1 or -1 for each knife: the side on which the piece lies; 0: the knife does not count
uniform highp sampler2D profiles;  // a knife's height over its plane at 256 places, one row per knife

float profile_at(int knife, float s) {
  float at = clamp(s * 0.5 + 0.5, 0.0, 1.0) * 255.0, low = floor(at);
  float a = texelFetch(profiles, ivec2(int(low), knife), 0).r;
  float b = texelFetch(profiles, ivec2(min(int(low) + 1, 255), knife), 0).r;
  return mix(a, b, at - low);
}

// `but`: the knife whose face contains the place, or -1.
bool is_cut_away(vec3 in_fruit, int but) {
  for (int k = 0; k < knives; ++k) {
    if (keep[k] == 0.0 || k == but) continue;
    float s = dot(knife_along[k].xyz, in_fruit) - knife_along[k].w;
    if (keep[k] * (dot(knife_plane[k].xyz, in_fruit) - knife_plane[k].w - profile_at(k, s)) < 0.0) return true;
  }
  return false;
}
