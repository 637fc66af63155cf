#include "generator/scene/mesh_solid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/mesh/edges.h"
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

}  // namespace

Solid mesh_solid(const PlainMesh& mesh, const std::string& name, const MeshSolidOptions& options) {
  Solid solid;
  solid.name = name;
  solid.part_names = {"dish"};
  solid.materials = {options.material};
  const std::vector<glm::dvec3> position = standing(mesh, options);
  const std::vector<std::uint32_t> first = weld(position);
  const std::vector<glm::uvec3> triangle = welded_triangles(first, mesh.triangle);
  const auto at = triangles_at(triangle, position.size());
  std::vector<glm::dvec3> area;  // twice, as vectors
  for (const glm::uvec3& t : triangle)
    area.push_back(glm::cross(position[t.y] - position[t.x], position[t.z] - position[t.x]));

  // A corner takes the mean normal of the triangles at its place that turn little against its own; corners of one
  // vertex with one normal are one vertex again.
  constexpr double least_cosine = 0.766;
  std::vector<std::vector<std::uint32_t>> known(mesh.position.size());
  double six_volumes = 0;
  for (std::size_t i = 0; i < mesh.triangle.size(); ++i) {
    const double own = glm::length(area[i]);
    if (!(own > 0)) continue;
    glm::uvec3 corners(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t vertex = mesh.triangle[i][k];
      glm::dvec3 sum(0);
      for (const std::uint32_t other : at[triangle[i][k]])
        if (glm::dot(area[i], area[other]) >= least_cosine * own * glm::length(area[other])) sum += area[other];
      const glm::vec3 normal(glm::normalize(sum));
      const auto same = std::find_if(known[vertex].begin(), known[vertex].end(),
                                     [&](std::uint32_t v) { return solid.normal[v] == normal; });
      if (same != known[vertex].end()) {
        corners[k] = *same;
        continue;
      }
      corners[k] = static_cast<std::uint32_t>(solid.position.size());
      known[vertex].push_back(corners[k]);
      solid.position.emplace_back(position[vertex]);
      solid.normal.push_back(normal);
      solid.color.push_back(options.color ? *options.color : mesh.color.empty() ? Color(0.6f) : mesh.color[vertex]);
    }
    solid.triangle.push_back(corners);
    const glm::uvec3& t = triangle[i];
    six_volumes += glm::dot(position[t.x], glm::cross(position[t.y], position[t.z]));
  }
  solid.part.assign(solid.position.size(), 0);
  solid.cut_face.assign(solid.triangle.size(), -1);
  solid.surface.assign(solid.triangle.size(), 0);
  solid.volume = std::fabs(six_volumes) / 6;
  solid.closed = is_closed(triangle);
  return solid;
}

}  // namespace pomona
