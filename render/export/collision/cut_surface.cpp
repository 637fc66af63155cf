#include "render/export/collision/cut_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "generator/mesh/signed_volume.h"

namespace pomona::collision {

namespace {

/// A triangle or what a plane leaves of it, at most four corners.
struct ClippedTriangle {
  std::array<glm::dvec3, 4> corner;
  std::array<bool, 4> on_plane{};
  std::size_t count = 0;

  void add(const glm::dvec3& p, bool is_on_plane) {
    corner[count] = p;
    on_plane[count++] = is_on_plane;
  }
};

/// What lies at heights of at most 0, heights counted times `sign`. The crossing of an edge is the same for both sides.
ClippedTriangle clipped(const Corners& triangle, const std::array<double, 3>& height, double sign) {
  ClippedTriangle kept;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double here = sign * height[i], there = sign * height[next];
    if (here <= 0) kept.add(triangle[i], here == 0);
    if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
      const bool forward = height[i] < height[next];
      const std::size_t low = forward ? i : next, high = forward ? next : i;
      const double share = height[low] / (height[low] - height[high]);
      kept.add(triangle[low] + share * (triangle[high] - triangle[low]), true);
    }
  }
  return kept;
}

/// One side of a plane while it takes triangles.
class PlaneSide {
 public:
  explicit PlaneSide(double sign) : sign_(sign) {}

  void take(const Corners& triangle, const std::array<double, 3>& height, std::vector<Corners> CutSurface::*list) {
    const ClippedTriangle kept = clipped(triangle, height, sign_);
    for (std::size_t i = 2; i < kept.count; ++i)
      (surface_.*list).push_back({kept.corner[0], kept.corner[i - 1], kept.corner[i]});
    if (kept.count < 3) return;
    for (std::size_t i = 0; i < kept.count; ++i) {
      const std::size_t next = (i + 1) % kept.count;
      if (kept.on_plane[i] && kept.on_plane[next]) close(kept.corner[i], kept.corner[next]);
    }
  }

  CutSurface surface() && { return std::move(surface_); }

 private:
  /// A cone over an edge of the cut.
  void close(const glm::dvec3& a, const glm::dvec3& b) {
    if (!tip_) tip_ = a;
    if (*tip_ != a && *tip_ != b) surface_.cones.push_back({*tip_, b, a});
  }

  double sign_;
  CutSurface surface_;
  std::optional<glm::dvec3> tip_;
};

/// Which way a line from a point along a direction passes through a triangle: 1 out of it, -1 into it, 0 if it does
/// not.
int crossing(const Corners& triangle, const glm::dvec3& from, const glm::dvec3& along) {
  const glm::dvec3 u = triangle[1] - triangle[0], v = triangle[2] - triangle[0], normal = glm::cross(u, v);
  const double rate = glm::dot(along, normal);
  if (rate == 0) return 0;
  const glm::dvec3 to = from - triangle[0], side = glm::cross(along, to);
  const double a = glm::dot(v, side) / rate, b = -glm::dot(u, side) / rate;
  const bool is_ahead = glm::dot(to, normal) / rate < 0;
  if (!is_ahead || a < 0 || b < 0 || a + b > 1) return 0;
  return rate > 0 ? 1 : -1;
}

/// Where three planes meet.
std::optional<glm::dvec3> meeting_of(const CuttingPlane& a, const CuttingPlane& b, const CuttingPlane& c) {
  const glm::dvec3 bc = glm::cross(b.normal, c.normal);
  const double determinant = glm::dot(a.normal, bc);
  if (std::abs(determinant) < 1e-6) return std::nullopt;
  return (a.offset * bc + b.offset * glm::cross(c.normal, a.normal) + c.offset * glm::cross(a.normal, b.normal)) /
         determinant;
}

/// Corners of the cut face that a plane would leave within the solid: where it meets two cuts before it.
std::vector<glm::dvec3> new_cut_corners(const CutSurface& surface, const CuttingPlane& plane) {
  constexpr double nothing = 1e-9;  // metres
  std::vector<glm::dvec3> corners;
  for (std::size_t i = 0; i < surface.cuts.size(); ++i) {
    for (std::size_t j = i + 1; j < surface.cuts.size(); ++j) {
      const CuttingPlane &first = surface.cuts[i], &second = surface.cuts[j];
      const std::optional<glm::dvec3> corner = meeting_of(first, second, plane);
      if (!corner) continue;
      const bool is_behind_all = std::all_of(surface.cuts.begin(), surface.cuts.end(), [&](const CuttingPlane& cut) {
        return glm::dot(cut.normal, *corner) <= cut.offset + nothing;
      });
      // A little within, as the corner itself lies on the surface.
      if (is_behind_all && surface.contains(*corner - 10 * nothing * (first.normal + second.normal)))
        corners.push_back(*corner);
    }
  }
  return corners;
}

/// The cuts of the part behind the plane, and their corners.
void add_cuts(CutSurface& part, const CutSurface& whole, const CuttingPlane& plane,
              const std::vector<glm::dvec3>& corners) {
  part.cuts = whole.cuts;
  part.cuts.push_back(plane);
  part.cut_corners = corners;
  for (const glm::dvec3& p : whole.cut_corners)
    if (glm::dot(plane.normal, p) <= plane.offset) part.cut_corners.push_back(p);
}

}  // namespace

double CutSurface::volume() const {
  const glm::dvec3 middle = skin.empty() ? glm::dvec3(0) : skin.front()[0];
  double six = 0;
  for (const std::vector<Corners>* list : {&skin, &cones})
    for (const Corners& t : *list) six += six_volumes(t[0] - middle, t[1] - middle, t[2] - middle);
  return six / 6;
}

std::vector<glm::vec3> CutSurface::points() const {
  std::vector<glm::vec3> all;
  for (const Corners& triangle : skin)
    for (const glm::dvec3& p : triangle) all.emplace_back(p);
  for (const glm::dvec3& p : cut_corners) all.emplace_back(p);
  std::sort(all.begin(), all.end(),
            [](const glm::vec3& a, const glm::vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

Box<double> CutSurface::box() const {
  Box<double> box;
  for (const Corners& triangle : skin)
    for (const glm::dvec3& p : triangle) box.add(p);
  return box;
}

bool CutSurface::contains(const glm::dvec3& point) const {
  const glm::dvec3 along(0.5416, 0.3127, 0.7803);  // along no face that people make
  int way = 0;
  for (const std::vector<Corners>* list : {&skin, &cones})
    for (const Corners& triangle : *list) way += crossing(triangle, point, along);
  return way > 0;
}

std::array<CutSurface, 2> divided(const CutSurface& surface, const CuttingPlane& plane) {
  PlaneSide behind(1), before(-1);
  for (const auto list : {&CutSurface::skin, &CutSurface::cones}) {
    for (const Corners& triangle : surface.*list) {
      std::array<double, 3> height{};
      for (std::size_t k = 0; k < 3; ++k) height[k] = glm::dot(plane.normal, triangle[k]) - plane.offset;
      behind.take(triangle, height, list);
      before.take(triangle, height, list);
    }
  }
  std::array<CutSurface, 2> parts{std::move(behind).surface(), std::move(before).surface()};
  const std::vector<glm::dvec3> corners = new_cut_corners(surface, plane);
  add_cuts(parts[0], surface, plane, corners);
  add_cuts(parts[1], surface, {-plane.normal, -plane.offset}, corners);
  return parts;
}

}  // namespace pomona::collision
