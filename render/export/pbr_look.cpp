#include "render/export/pbr_look.h"

#include <algorithm>
#include <cmath>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

/// Two digits: no eye tells more, and fewer different materials come of it.
double rounded(double value) { return std::round(100 * value) / 100; }

std::array<double, 3> rounded(const glm::dvec3& color) {
  return {rounded(color.r), rounded(color.g), rounded(color.b)};
}

PbrLook look_of_skin(const MaterialSketch& material) {
  // A template's roughness of 0.3 is glTF's 0.6; smoother skins shine by their coat, rougher ones lose their shine.
  const double smoothness = std::max(0.0, 0.3 - material.roughness);
  PbrLook look;
  look.roughness = rounded(0.6 + (material.roughness > 0.3 ? 0.57 * (material.roughness - 0.3) : -0.8 * smoothness));
  look.specular = rounded(std::min(material.gloss, 1.0));
  look.clearcoat = rounded(std::min(1.0, 3.2 * smoothness * material.gloss));
  if (look.clearcoat > 0) look.clearcoat_roughness = rounded(material.roughness);

  const double hair = 1 - reproducible::exp(-0.9e3 * material.fuzz.length * material.fuzz.density);
  const glm::dvec3 sheen =
      glm::dvec3(material.fuzz.color) * 0.8 * hair + glm::dvec3(material.bloom.color) * 0.5 * material.bloom.cover;
  look.sheen = rounded(glm::min(sheen, glm::dvec3(1)));
  if (look.sheen != std::array<double, 3>{}) look.sheen_roughness = hair > 0 ? 0.6 : 0.4;
  return look;
}

PbrLook look_of_cut_face(const MaterialSketch& material) {
  PbrLook look;
  look.roughness = rounded(0.6 + 0.25 * std::max(0.0, 1 - material.wet));
  look.clearcoat = rounded(std::min(0.7, 0.3 * std::max(0.0, material.wet - 1)));
  if (look.clearcoat > 0) look.clearcoat_roughness = 0.2;
  return look;
}

}  // namespace

PbrLook look_of(const MaterialSketch& material, bool on_cut_face) {
  PbrLook look = on_cut_face ? look_of_cut_face(material) : look_of_skin(material);
  const double millimetres = 1000 * material.translucency.depth;
  look.transmission = rounded(0.45 * millimetres / (millimetres + 1));
  if (look.transmission > 0) look.transmission_color = rounded(glm::dvec3(material.translucency.color));
  return look;
}

std::vector<LookGroup> groups_by_look(const Solid& solid, const StyledMesh& mesh) {
  std::vector<LookGroup> groups;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const PbrLook look = solid.materials.empty()
                             ? PbrLook{}
                             : look_of(material_of(solid, mesh.part[mesh.triangle[t].x]), mesh.cut_face[t] >= 0);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const LookGroup& known) { return known.look == look; });
    if (group == groups.end()) group = groups.insert(groups.end(), LookGroup{look, {}});
    group->triangle.push_back(mesh.triangle[t]);
  }
  return groups;
}

}  // namespace pomona
