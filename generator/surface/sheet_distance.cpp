#include "generator/surface/sheet_distance.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

class SheetDistances {
 public:
  SheetDistances(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normals)
      : surfaces_(surfaces), normals_(normals), first_(weld(surfaces.position)) {}

  std::vector<float> find() {
    start_with_blur();
    for_each_edge(sorted_half_edges(welded_triangles(first_, surfaces_.triangle)),
                  [&](std::span<const HalfEdge> edge) { limit_at(edge); });
    std::vector<float> distances(surfaces_.vertex_count());
    for (std::size_t v = 0; v < distances.size(); ++v) distances[v] = static_cast<float>(distance_[first_[v]]);
    return distances;
  }

 private:
  /// The least blur of all vertices at one position, so that sheets do not tear.
  void start_with_blur() {
    distance_.assign(surfaces_.vertex_count(), 0);
    for (std::size_t v = 0; v < distance_.size(); ++v) {
      const double blur = std::max(0.0f, surfaces_.blur[v]);
      double& known = distance_[first_[v]];
      known = first_[v] == v ? blur : std::min(known, blur);
    }
  }

  void limit_at(std::span<const HalfEdge> edge) {
    const std::uint32_t a = edge.front().low, b = edge.front().high;
    std::size_t boundary = 0;
    bool outwards = false, inwards = false;  // along the normal, against it
    for (const HalfEdge& h : edge) {
      const bool is_boundary = surfaces_.is_boundary(h.triangle);
      boundary += is_boundary ? 1 : 0;
      outwards = outwards || !is_boundary || surfaces_.is_hidden(h.triangle, SideOf::back);
      inwards = inwards || !is_boundary || surfaces_.is_hidden(h.triangle, SideOf::front);
    }
    const bool rim = edge.size() == 1;
    const bool changes = boundary != 0 && boundary != edge.size();
    const double most = rim || changes ? 0 : farthest_unfolded(a, b, outwards, inwards);
    distance_[a] = std::min(distance_[a], most);
    distance_[b] = std::min(distance_[b], most);
  }

  /// 0.4 of the radius by which the normals of an edge's ends turn along it, if towards a moving sheet.
  double farthest_unfolded(std::uint32_t a, std::uint32_t b, bool outwards, bool inwards) const {
    const glm::dvec3 edge = glm::dvec3(surfaces_.position[b]) - glm::dvec3(surfaces_.position[a]);
    const double spread = glm::dot(glm::dvec3(normals_[b]) - glm::dvec3(normals_[a]), edge);
    const double closing = std::max(outwards ? -spread : 0.0, inwards ? spread : 0.0);
    constexpr double share_of_radius = 0.4;
    const double unlimited = std::max(distance_[a], distance_[b]);
    return closing > 0 ? std::min(unlimited, share_of_radius * glm::dot(edge, edge) / closing) : unlimited;
  }

  const DiffusionSurfaces& surfaces_;
  const std::vector<glm::vec3>& normals_;
  std::vector<std::uint32_t> first_;
  std::vector<double> distance_;  ///< per welded vertex
};

}  // namespace

std::vector<float> sheet_distances(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normals) {
  return SheetDistances(surfaces, normals).find();
}

}  // namespace pomona
