#include "render/gl/scene_materials.h"

#include <algorithm>
#include <array>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

constexpr std::size_t texels_each = 5;  // the same in shaders/material.glsl
constexpr int max_materials = 2048;     // half floats are exact up to here

/// The share that hairs too fine to be drawn cover: more for long and dense fuzz.
double fuzz_cover(const Fuzz& fuzz) {
  const double millimetres = 1000 * fuzz.length * fuzz.density;  // millimetres of hair per square millimetre
  return 0.75 * (1 - reproducible::exp(-0.9 * millimetres));
}

std::array<glm::vec4, texels_each> texels_of(const MaterialSketch& m) {
  return {glm::vec4(m.gloss, m.roughness, m.wet, m.translucency.depth), glm::vec4(m.translucency.color, m.bloom.cover),
          glm::vec4(m.bloom.color, 1 / std::max(m.bloom.patch_size, 1e-6)), glm::vec4(m.fuzz.color, fuzz_cover(m.fuzz)),
          glm::vec4(m.bloom.rubbed, m.fuzz.length, m.pit, m.relief)};
}

}  // namespace

std::vector<glm::vec4> material_texels(const MaterialSketch& material) {
  const std::array<glm::vec4, texels_each> texels = texels_of(material);
  return {texels.begin(), texels.end()};
}

float SceneMaterials::number_of(const MaterialSketch& material) {
  const std::array<glm::vec4, texels_each> texels = texels_of(material);
  std::vector<float> key;
  for (const glm::vec4& texel : texels) key.insert(key.end(), {texel.x, texel.y, texel.z, texel.w});
  const int next = static_cast<int>(texels_.size() / texels_each);
  const auto [entry, is_new] = known_.try_emplace(key, next < max_materials ? next : 0);
  if (is_new && next < max_materials) texels_.insert(texels_.end(), texels.begin(), texels.end());
  return static_cast<float>(entry->second);
}

std::vector<float> SceneMaterials::numbers_of(const Solid& solid) {
  std::vector<float> of_part;
  const std::size_t parts = std::max<std::size_t>(solid.look->materials.size(), 1) + 1;
  for (std::size_t part = 0; part < parts; ++part) {
    of_part.push_back(number_of(material_of(solid, static_cast<std::int32_t>(part))));
  }
  std::vector<float> numbers;
  numbers.reserve(solid.mesh.part.size());
  for (const std::int32_t part : solid.mesh.part) {
    const bool known = part >= 0 && static_cast<std::size_t>(part) < of_part.size();
    numbers.push_back(known ? of_part[static_cast<std::size_t>(part)] : of_part.back());
  }
  return numbers;
}

bool lets_light_in(const Solid& solid) {
  return std::any_of(solid.look->materials.begin(), solid.look->materials.end(),
                     [](const MaterialSketch& m) { return m.translucency.depth > 0; });
}

}  // namespace pomona
