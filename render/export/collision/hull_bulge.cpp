#include "render/export/collision/hull_bulge.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace pomona::collision {

namespace {

constexpr double sliver = 1e-12;  // square metres, as cuts leave them: no normal to rely on
constexpr double unbounded = std::numeric_limits<double>::infinity();

/// How far it is from a point to the outside of the hull along a direction. Faces that the way does not lead to are not
/// asked: a hull of few corners leaves out some of a thin wall, and what is left of the hull may all lie before it.
double way_out(const std::vector<FacePlane>& faces, const glm::dvec3& point, const glm::dvec3& along) {
  double way = unbounded;
  for (const FacePlane& face : faces) {
    const double depth = face.offset - glm::dot(face.normal, point), rate = glm::dot(face.normal, along);
    if (rate > 1e-9 && depth < way * rate) way = depth / rate;
  }
  return way == unbounded ? 0 : std::max(way, 0.0);
}

}  // namespace

std::vector<FacePlane> faces_of(const ConvexHull& hull) {
  std::vector<FacePlane> faces;
  for (const glm::uvec3& t : hull.triangle) {
    const glm::dvec3 a(hull.position[t.x]), b(hull.position[t.y]), c(hull.position[t.z]);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double length = glm::length(area);
    if (length > 0) faces.push_back({area / length, glm::dot(area / length, a)});
  }
  return faces;
}

double depth_in(const std::vector<FacePlane>& faces, const glm::dvec3& point) {
  double depth = faces.empty() ? -unbounded : unbounded;
  for (const FacePlane& face : faces) depth = std::min(depth, face.offset - glm::dot(face.normal, point));
  return depth;
}

std::optional<Bulge> largest_bulge(const ConvexHull& hull, const CutSurface& surface, double least,
                                   const std::vector<char>& given_up) {
  const std::vector<FacePlane> faces = faces_of(hull);
  std::optional<Bulge> largest;
  for (std::size_t t = 0; t < surface.skin.size(); ++t) {
    if (given_up[t]) continue;
    const Corners& c = surface.skin[t];
    const glm::dvec3 area = glm::cross(c[1] - c[0], c[2] - c[0]), middle = (c[0] + c[1] + c[2]) / 3.0;
    const double length = glm::length(area);
    if (!(length > sliver)) continue;
    const glm::dvec3 normal = area / length;
    const double way = way_out(faces, middle, normal);
    if (way <= least) continue;
    least = way;
    largest = Bulge{way, t, {normal, glm::dot(normal, middle)}};
  }
  return largest;
}

}  // namespace pomona::collision
