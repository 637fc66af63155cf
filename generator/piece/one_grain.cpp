#include "generator/piece/one_grain.h"

#include <cstdint>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/box.h"
#include "generator/mesh/connected_vertices.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"

namespace pomona {

namespace {

bool is_seed(const std::string& part) {
  for (const char* word : {"seed", "stone", "pip", "achene", "kernel"}) {
    if (part.find(word) != std::string::npos) return true;
  }
  return false;
}

/// The connected set of the longest seed, if any.
std::optional<std::uint32_t> longest_seed(const DiffusionSurfaces& grains, DisjointSets& sets) {
  std::map<std::uint32_t, Box<double>> boxes;
  for (std::size_t t = 0; t < grains.triangle_count(); ++t) {
    if (!is_seed(grains.part_names[static_cast<std::size_t>(grains.back_part[t])])) continue;
    Box<double>& box = boxes[sets.root(grains.triangle[t].x)];
    for (int k = 0; k < 3; ++k) box.add(glm::dvec3(grains.position[grains.triangle[t][k]]));
  }
  double best = -1;
  std::optional<std::uint32_t> longest;
  for (const auto& [set, box] : boxes) {
    const glm::dvec3 size = box.size();
    const double squared = glm::dot(size, size);
    if (squared > best) best = squared, longest = set;
  }
  return longest;
}

}  // namespace

std::optional<Solid> one_grain(const GrownFruit& fruit, const Template& variant, const std::string& name) {
  const DiffusionSurfaces& grains = fruit.grains;
  DisjointSets sets = connected_vertices(grains.vertex_count(), grains.triangle);
  const std::optional<std::uint32_t> wanted = longest_seed(grains, sets);
  if (!wanted) return std::nullopt;

  Solid solid;
  solid.name = name + ".grain";
  solid.look = std::make_shared<const FruitLook>(look_of(variant, grains.part_names));
  const std::vector<glm::vec3> normal = vertex_normals(grains);
  std::map<std::uint32_t, std::uint32_t> copies;
  for (std::size_t t = 0; t < grains.triangle_count(); ++t) {
    if (sets.root(grains.triangle[t].x) != *wanted) continue;
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = grains.triangle[t][k];
      const auto [copy, is_new] = copies.try_emplace(v, static_cast<std::uint32_t>(solid.mesh.position.size()));
      corners[k] = copy->second;
      if (!is_new) continue;

      // Within its fruit a grain's front faces flesh; by itself it has the colour of its inside.
      solid.mesh.position.push_back(grains.position[v]);
      solid.mesh.normal.push_back(normal[v]);
      solid.mesh.color.push_back(grains.back_color[v]);
      solid.mesh.part.push_back(grains.back_part[t]);
    }
    solid.mesh.triangle.push_back(corners);
    solid.mesh.cut_face.push_back(-1);
    solid.mesh.surface.push_back(grains.surface[t]);
  }
  solid.closed = is_closed(welded_triangles(weld(solid.mesh.position), solid.mesh.triangle));
  return solid;
}

}  // namespace pomona
