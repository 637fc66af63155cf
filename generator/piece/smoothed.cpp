#include "generator/piece/smoothed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/edge_map.h"

namespace pomona {

namespace {

constexpr float pull = 0.75f;  // share of the way from the chord to the mean of both tangent planes

glm::vec3 onto_plane(const glm::vec3& point, const glm::vec3& foot, const glm::vec3& normal) {
  return point - normal * glm::dot(point - foot, normal);
}

/// Adds the vertices in the middles of edges, each once.
class Halving {
 public:
  explicit Halving(Solid& solid) : mesh_(solid.mesh) {}

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const EdgeKey edge(a, b);
    const auto [middle, is_new] = middles_.try_emplace(edge, static_cast<std::uint32_t>(mesh_.position.size()));
    if (!is_new) return middle;
    const auto [low, high] = edge;
    const glm::vec3 p = mesh_.position[low], q = mesh_.position[high], chord = (p + q) * 0.5f;
    const glm::vec3 m = mesh_.normal[low], n = mesh_.normal[high], sum = m + n;
    const glm::vec3 round = (onto_plane(chord, p, m) + onto_plane(chord, q, n)) * 0.5f;
    const float length = std::sqrt(glm::dot(sum, sum));
    mesh_.position.push_back(chord + (round - chord) * pull);
    mesh_.normal.push_back(length > 0 ? sum / length : m);
    mesh_.color.push_back((mesh_.color[low] + mesh_.color[high]) * 0.5f);
    mesh_.part.push_back(mesh_.part[low]);
    return middle;
  }

 private:
  SolidMesh& mesh_;
  EdgeMap<std::uint32_t> middles_;
};

}  // namespace

Solid smoothed(Solid solid, int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    Halving halving(solid);
    std::vector<glm::uvec3> triangle;
    std::vector<std::int32_t> cut_face, surface, instance;
    for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
      const glm::uvec3 v = solid.mesh.triangle[t];
      const std::uint32_t a = halving.middle(v.x, v.y), b = halving.middle(v.y, v.z), c = halving.middle(v.z, v.x);
      for (const glm::uvec3& part :
           {glm::uvec3(v.x, a, c), glm::uvec3(v.y, b, a), glm::uvec3(v.z, c, b), glm::uvec3(a, b, c)}) {
        triangle.push_back(part);
        cut_face.push_back(solid.mesh.cut_face[t]);
        surface.push_back(solid.mesh.surface[t]);
        if (!solid.mesh.instance.empty()) instance.push_back(solid.mesh.instance[t]);
      }
    }
    solid.mesh.triangle = std::move(triangle);
    solid.mesh.cut_face = std::move(cut_face);
    solid.mesh.surface = std::move(surface);
    solid.mesh.instance = std::move(instance);
  }
  return solid;
}

}  // namespace pomona
