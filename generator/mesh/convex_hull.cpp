// The one file that knows Bullet's hull computer.
#include "generator/mesh/convex_hull.h"

#include <cmath>

#include <LinearMath/btConvexHullComputer.h>
#include <glm/geometric.hpp>

namespace pomona {

namespace {

static_assert(sizeof(btScalar) == sizeof(double), "Bullet's headers and library must agree on double precision");

/// Fans each face's polygon out from its first corner.
std::vector<glm::uvec3> triangulated(const btConvexHullComputer& hull) {
  std::vector<glm::uvec3> triangles;
  for (int f = 0; f < hull.faces.size(); ++f) {
    const btConvexHullComputer::Edge* const start = &hull.edges[hull.faces[f]];
    const auto apex = static_cast<unsigned>(start->getSourceVertex());
    for (auto* edge = start->getNextEdgeOfFace(); edge != start; edge = edge->getNextEdgeOfFace()) {
      const glm::uvec3 t(apex, edge->getSourceVertex(), edge->getTargetVertex());
      if (t.y != apex && t.z != apex) triangles.push_back(t);
    }
  }
  return triangles;
}

}  // namespace

double volume(const ConvexHull& hull) {
  double six = 0;
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3& a = hull.point[t.x];
    six += glm::dot(a - hull.point[0], glm::cross(hull.point[t.y] - hull.point[0], hull.point[t.z] - hull.point[0]));
  }
  return std::fabs(six) / 6;
}

ConvexHull convex_hull(std::span<const glm::dvec3> points) {
  ConvexHull hull;
  if (points.empty()) return hull;
  btConvexHullComputer computer;
  computer.compute(&points[0].x, sizeof(glm::dvec3), static_cast<int>(points.size()), 0, 0);
  for (int i = 0; i < computer.vertices.size(); ++i)
    hull.point.push_back(points[static_cast<std::size_t>(computer.original_vertex_index[i])]);
  hull.triangle = triangulated(computer);
  return hull;
}

std::vector<glm::dvec3> shrunken_corners(std::span<const glm::dvec3> points, double by) {
  if (points.empty()) return {};
  btConvexHullComputer computer;
  computer.compute(&points[0].x, sizeof(glm::dvec3), static_cast<int>(points.size()), by, 0.5);
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < computer.vertices.size(); ++i) {
    const btVector3& v = computer.vertices[i];
    corners.emplace_back(v.x(), v.y(), v.z());
  }
  if (corners.size() < 4) corners.assign(points.begin(), points.end());
  return corners;
}

}  // namespace pomona
