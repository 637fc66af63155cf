#include "render/export/pbr_material.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

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

namespace {

std::string name_of_part(const Solid& solid, std::int32_t part) {
  const auto number = static_cast<std::size_t>(part);
  return part >= 0 && number < solid.look->part_names.size() ? solid.look->part_names[number] : std::string();
}

/// The look of one of a solid's parts.
PbrMaterial look_of_part(const Solid& solid, std::int32_t part, bool on_cut_face, LightInside light) {
  const MaterialSketch material = material_of(solid, part);
  PbrMaterial look = look_of(material, on_cut_face);
  if (light == LightInside::told) look.inside = tissue_light(material, name_of_part(solid, part));
  return look;
}

/// The one look of a solid whose template has no materials: inside, it is what most of its triangles are.
PbrMaterial look_of_all(const Solid& solid, const StyledMesh& mesh, LightInside light) {
  PbrMaterial look;
  if (light == LightInside::left_out) return look;
  std::map<std::int32_t, std::size_t> triangles;
  for (const glm::uvec3& t : mesh.triangle) ++triangles[mesh.part[t.x]];
  const auto most = std::max_element(triangles.begin(), triangles.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most != triangles.end()) look.inside = tissue_light({}, name_of_part(solid, most->first));
  return look;
}

/// The parts that have a look on skins, and on cut faces.
struct PartsOfMaterial {
  PbrMaterial look;
  std::vector<std::size_t> on_skin, on_cut;
};

std::vector<PartsOfMaterial> parts_by_material(const Solid& solid, LightInside light) {
  std::vector<PartsOfMaterial> all;
  const auto of = [&](const PbrMaterial& look) -> PartsOfMaterial& {
    const auto at =
        std::find_if(all.begin(), all.end(), [&](const PartsOfMaterial& known) { return known.look == look; });
    return at != all.end() ? *at : all.emplace_back(PartsOfMaterial{look, {}, {}});
  };
  for (std::size_t part = 0; part < solid.look->part_names.size(); ++part) {
    const auto number = static_cast<std::int32_t>(part);
    if (solid.look->on_skin.empty() || solid.look->on_skin[part] != 0)
      of(look_of_part(solid, number, false, light)).on_skin.push_back(part);
    of(look_of_part(solid, number, true, light)).on_cut.push_back(part);
  }
  return all;
}

/// A single part gives its name; several are "inside" or "outside" if no other look has more parts.
std::string name_of(const std::vector<std::size_t>& parts, std::size_t max, const char* max_called,
                    const std::vector<std::string>& part_names) {
  if (parts.size() > 1 && parts.size() == max) return max_called;
  std::string name;
  for (const std::size_t part : parts) name += (name.empty() ? "" : ", ") + part_names[part];
  return name;
}

/// A name for each look that a solid's parts can have, even if this piece does not show it, so that all pieces of a
/// fruit agree.
std::vector<std::pair<PbrMaterial, std::string>> named_materials(const Solid& solid, LightInside light) {
  const std::vector<PartsOfMaterial> all = parts_by_material(solid, light);
  std::size_t max_inside = 0, max_outside = 0;
  for (const PartsOfMaterial& of : all) {
    max_inside = std::max(max_inside, of.on_cut.size());
    if (of.on_cut.empty()) max_outside = std::max(max_outside, of.on_skin.size());
  }
  std::vector<std::pair<PbrMaterial, std::string>> named;
  for (const PartsOfMaterial& of : all) {
    const bool is_inside = !of.on_cut.empty();
    std::string name = is_inside ? name_of(of.on_cut, max_inside, "inside", solid.look->part_names)
                                 : name_of(of.on_skin, max_outside, "outside", solid.look->part_names);
    while (std::any_of(named.begin(), named.end(), [&](const auto& other) { return other.second == name; }))
      name += is_inside ? " cut" : " skin";
    named.emplace_back(of.look, std::move(name));
  }
  return named;
}

}  // namespace

std::vector<MaterialGroup> groups_by_material(const Solid& solid, const StyledMesh& mesh, LightInside light) {
  const bool is_one = solid.look->materials.empty();
  const PbrMaterial of_all = look_of_all(solid, mesh, light);
  const auto names = is_one ? std::vector<std::pair<PbrMaterial, std::string>>{} : named_materials(solid, light);
  const auto name_of_material = [&](const PbrMaterial& look) {
    const auto at = std::find_if(names.begin(), names.end(), [&](const auto& named) { return named.first == look; });
    return at == names.end() ? std::string() : at->second;
  };
  std::vector<MaterialGroup> groups;
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    const PbrMaterial look =
        is_one ? of_all : look_of_part(solid, mesh.part[mesh.triangle[t].x], mesh.cut_face[t] >= 0, light);
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const MaterialGroup& known) { return known.look == look; });
    if (group == groups.end()) group = groups.insert(groups.end(), MaterialGroup{look, name_of_material(look), {}, {}});
    group->face.push_back(static_cast<std::int32_t>(t));
    group->triangle.push_back(mesh.triangle[t]);
  }
  return groups;
}

}  // namespace pomona
