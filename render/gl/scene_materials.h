// A scene's materials as shaders read them (shaders/material.glsl).
#pragma once

#include <map>
#include <vector>

#include <glm/vec4.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// One material's texels.
std::vector<glm::vec4> material_texels(const MaterialSketch& material);

/// Every different material once.
class SceneMaterials {
 public:
  SceneMaterials() { number_of({}); }
  /// The index for shaders. After 2048 different materials, 0: the default.
  float number_of(const MaterialSketch& material);
  /// The numbers of a solid's vertices.
  std::vector<float> numbers_of(const Solid& solid);

  const std::vector<glm::vec4>& texels() const { return texels_; }

 private:
  std::map<std::vector<float>, int> known_;
  std::vector<glm::vec4> texels_;
};

/// Whether light passes through any part of it.
bool lets_light_in(const Solid& solid);

}  // namespace pomona
