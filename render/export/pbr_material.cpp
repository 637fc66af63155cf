#include "render/export/pbr_material.h"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

namespace pomona {

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

namespace {

/// The group of the given groups' triangles, in the order of the mesh.
MaterialGroup joined(std::span<const MaterialGroup* const> groups) {
  const auto largest = std::max_element(groups.begin(), groups.end(), [](const auto* a, const auto* b) {
    return a->triangle.size() < b->triangle.size();
  });
  const PbrMaterial& most = (*largest)->look;
  MaterialGroup all;
  all.look.transmission = most.transmission;
  all.look.transmission_color = most.transmission_color;
  all.look.clearness = most.clearness;
  all.look.inside = most.inside;
  std::vector<std::pair<std::int32_t, glm::uvec3>> faces;
  for (const MaterialGroup* group : groups) {
    for (std::size_t i = 0; i < group->face.size(); ++i) faces.emplace_back(group->face[i], group->triangle[i]);
  }
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [face, triangle] : faces) all.face.push_back(face), all.triangle.push_back(triangle);
  return all;
}

}  // namespace

std::vector<MaterialGroup> groups_in_maps(const std::vector<MaterialGroup>& groups) {
  std::vector<const MaterialGroup*> dense, clear;
  for (const MaterialGroup& group : groups) (group.look.clearness > 0 ? clear : dense).push_back(&group);
  std::vector<MaterialGroup> result;
  if (!dense.empty()) result.push_back(joined(dense));
  if (!clear.empty()) {
    result.push_back(joined(clear));
    result.back().name = "clear";
  }
  return result;
}

}  // namespace pomona
