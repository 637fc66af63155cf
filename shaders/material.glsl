// The materials of parts (generator/template/material_sketch.h), and the bloom and fuzz on their skins.
#include "noise.glsl"

// Every material's texels (render/gl/scene_materials.h): gloss, roughness, wet, depth that light reaches in metres;
// its colour, how much bloom covers; bloom's colour and frequency; fuzz's colour, how much it covers; share of the
// bloom that is rubbed off, length of the fuzz, depth of the pit around the part, relief of the part on cut faces (pages alone ask).
uniform samplerBuffer materials;
const int material_texels = 5;

struct Material {
  float gloss, roughness, wet;
  float depth;
  vec3 inner_color;
  vec4 bloom;       // colour, cover
  float patches;    // cycles per metre
  float rubbed;
  vec4 fuzz;        // colour, cover
  float pit;        // metres
};

Material material_at(float number) {
  int first = material_texels * int(number + 0.5);
  vec4 surface = texelFetch(materials, first);
  vec4 inner = texelFetch(materials, first + 1);
  vec4 bloom = texelFetch(materials, first + 2);
  vec4 fuzz = texelFetch(materials, first + 3);
  vec4 more = texelFetch(materials, first + 4);
  return Material(surface.x, surface.y, surface.z, surface.w, inner.rgb, vec4(bloom.rgb, inner.a), bloom.a, more.x,
                  fuzz, more.z);
}

// How much of a skin the bloom hides here: more at grazing angles; it is rubbed off in patches with smears and
// scratches.
float bloom_cover(Material m, vec3 position, float cosine) {
  if (m.bloom.a <= 0.0) return 0.0;
  float where = 0.0;
  int k = 0, sizes = m.bloom.a > 0.0 ? 2 : 1;  // one where the branch above has been taken (README.md)
  do where += (k == 0 ? 1.0 : 0.45) * gradient_noise(position * m.patches * (k == 0 ? 1.0 : 3.1), 401u + uint(k));
  while (++k < sizes);
  float edge = 1.3 * (2.0 * m.rubbed - 1.0);
  float whole = m.rubbed <= 0.0 ? 1.0 : m.rubbed >= 1.0 ? 0.0 : smoothstep(edge - 0.28, edge + 0.28, where);
  float slant = 1.0 - cosine;
  return m.bloom.a * mix(0.12, 1.0, whole) * (0.35 + 0.65 * slant * (2.0 - slant));
}
