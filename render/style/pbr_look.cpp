#include "render/style/pbr_look.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "generator/base/reproducible.h"
#include "render/style/pbr_roughness.h"

namespace pomona {

namespace {

/// Two digits: more are invisible, and equal materials are shared.
double rounded(double value) { return std::round(100 * value) / 100; }

std::array<double, 3> rounded(const glm::dvec3& color) {
  return {rounded(color.r), rounded(color.g), rounded(color.b)};
}

PbrMaterial material_of_skin(const MaterialSketch& material) {
  // A template's roughness of 0.3 is glTF's 0.6; smoother skins shine by their coat, rougher ones lose their shine.
  const double smoothness = std::max(0.0, 0.3 - material.roughness);
  PbrMaterial look;
  look.roughness = rounded(pbr_roughness(material, false));
  look.specular = rounded(std::min(material.gloss, 1.0));
  look.clearcoat = rounded(material.coat.value_or(std::min(1.0, 3.2 * smoothness * material.gloss)));
  if (look.clearcoat > 0) look.clearcoat_roughness = rounded(material.roughness);

  const double hair = 1 - reproducible::exp(-0.9e3 * material.fuzz.length * material.fuzz.density);
  const glm::dvec3 sheen =
      glm::dvec3(material.fuzz.color) * 0.8 * hair + glm::dvec3(material.bloom.color) * 0.5 * material.bloom.cover;
  look.sheen = rounded(glm::min(sheen, glm::dvec3(1)));
  if (look.sheen != std::array<double, 3>{}) look.sheen_roughness = hair > 0 ? 0.6 : 0.4;
  return look;
}

PbrMaterial material_of_cut_face(const MaterialSketch& material) {
  PbrMaterial look;
  look.roughness = rounded(pbr_roughness(material, true));
  look.clearcoat = rounded(pbr_film(material));
  if (look.clearcoat > 0) look.clearcoat_roughness = 0.15;
  return look;
}

}  // namespace

PbrMaterial look_of(const MaterialSketch& material, bool on_cut_face) {
  PbrMaterial look = on_cut_face ? material_of_cut_face(material) : material_of_skin(material);
  const double millimetres = 1000 * material.translucency.depth;
  look.transmission = rounded(0.45 * millimetres / (millimetres + 1));
  if (look.transmission > 0) look.transmission_color = rounded(glm::dvec3(material.translucency.color));
  look.clearness = rounded(material.transmission.value_or(0));
  return look;
}

}  // namespace pomona
