#include "generator/scene/mesh_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
#include "generator/mesh/signed_volume.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

std::vector<glm::dvec3> standing(const PlainMesh& mesh, const MeshSolidOptions& options) {
  std::vector<glm::dvec3> position;
  double lowest = std::numeric_limits<double>::max();
  for (const glm::dvec3& p : mesh.position) {
    position.push_back((options.z_up ? glm::dvec3(p.x, p.z, -p.y) : p) * options.unit);
    lowest = std::min(lowest, position.back().y);
  }
  for (glm::dvec3& p : position) p.y -= lowest;
  return position;
}

/// Triangles at each place, after welding.
std::vector<std::vector<std::uint32_t>> triangles_at(const std::vector<glm::uvec3>& triangle, std::size_t places) {
  std::vector<std::vector<std::uint32_t>> at(places);
  for (std::size_t t = 0; t < triangle.size(); ++t)
    for (int k = 0; k < 3; ++k) at[triangle[t][k]].push_back(static_cast<std::uint32_t>(t));
  return at;
}

/// The vertices of the corners of a mesh, each with a normal.
class CornerVertices {
 public:
  CornerVertices(const std::vector<glm::uvec3>& triangle, const std::vector<glm::dvec3>& position, std::size_t vertices)
      : triangle_(triangle), at_(triangles_at(triangle, position.size())), known_(vertices) {
    for (const glm::uvec3& t : triangle)
      area_.push_back(glm::cross(position[t.y] - position[t.x], position[t.z] - position[t.x]));
  }

  bool has_area(std::size_t i) const { return glm::length(area_[i]) > 0; }

  /// The mean normal of the triangles at corner k of triangle i that turn little against it. Where very many meet, as
  /// at the tip of a cone, it is the triangle's own, because comparing all pairs would take hours.
  glm::vec3 normal_at(std::size_t i, int k) const {
    constexpr double min_cosine = 0.766;
    if (is_crowded(i, k)) return glm::vec3(glm::normalize(area_[i]));
    const double own = glm::length(area_[i]);
    glm::dvec3 sum(0);
    for (const std::uint32_t other : at_[triangle_[i][k]])
      if (glm::dot(area_[i], area_[other]) >= min_cosine * own * glm::length(area_[other])) sum += area_[other];
    return glm::vec3(glm::normalize(sum));
  }

  /// Corners of one vertex with one normal become one vertex: an index of `normals`, or none yet.
  std::optional<std::uint32_t> known(std::uint32_t vertex, const glm::vec3& normal,
                                     const std::vector<glm::vec3>& normals) const {
    const std::vector<std::uint32_t>& some = known_[vertex];
    const auto same = std::find_if(some.begin(), some.end(), [&](std::uint32_t v) { return normals[v] == normal; });
    return same != some.end() ? std::optional(*same) : std::nullopt;
  }
  void remember(std::uint32_t vertex, std::uint32_t as) {
    if (known_[vertex].size() < max_together) known_[vertex].push_back(as);
  }

 private:
  static constexpr std::size_t max_together = 256;  // limit of triangles at a place
  bool is_crowded(std::size_t i, int k) const { return at_[triangle_[i][k]].size() > max_together; }

  const std::vector<glm::uvec3>& triangle_;
  std::vector<std::vector<std::uint32_t>> at_;
  std::vector<glm::dvec3> area_;  ///< area vectors, twice
  std::vector<std::vector<std::uint32_t>> known_;
};

/// Only triangles that face the eye are drawn of closed solids, and files may have them inside out.
void turn_outside_out(Solid& solid) {
  for (glm::uvec3& t : solid.mesh.triangle) std::swap(t.y, t.z);
  for (glm::vec3& normal : solid.mesh.normal) normal = -normal;
}

}  // namespace

Solid mesh_solid(const PlainMesh& mesh, const std::string& name, const MeshSolidOptions& options) {
  Solid solid;
  solid.name = name;
  solid.look = std::make_shared<const FruitLook>(FruitLook{.part_names = {"dish"}, .materials = {options.material}});
  const std::vector<glm::dvec3> position = standing(mesh, options);
  const std::vector<std::uint32_t> first = weld(position);
  const std::vector<glm::uvec3> triangle = welded_triangles(first, mesh.triangle);
  CornerVertices corner_vertices(triangle, position, mesh.position.size());
  double six = 0;
  for (std::size_t i = 0; i < mesh.triangle.size(); ++i) {
    if (!corner_vertices.has_area(i)) continue;
    glm::uvec3 corners(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangle[i][k];
      const glm::vec3 normal = corner_vertices.normal_at(i, k);
      const std::optional<std::uint32_t> known = corner_vertices.known(vertex, normal, solid.mesh.normal);
      corners[k] = known.value_or(static_cast<std::uint32_t>(solid.mesh.position.size()));
      if (known) continue;
      corner_vertices.remember(vertex, corners[k]);
      solid.mesh.position.emplace_back(position[vertex]);
      solid.mesh.normal.push_back(normal);
      solid.mesh.color.push_back(options.color        ? *options.color
                                 : mesh.color.empty() ? Color(0.6f)
                                                      : mesh.color[vertex]);
    }
    solid.mesh.triangle.push_back(corners);
    const glm::uvec3& t = triangle[i];
    six += six_volumes(position[t.x], position[t.y], position[t.z]);
  }
  solid.mesh.part.assign(solid.mesh.position.size(), 0);
  solid.mesh.cut_face.assign(solid.mesh.triangle.size(), -1);
  solid.mesh.surface.assign(solid.mesh.triangle.size(), 0);
  solid.volume = std::fabs(six) / 6;
  solid.closed = is_closed(triangle);
  if (solid.closed && six < 0) turn_outside_out(solid);
  return solid;
}

}  // namespace pomona
