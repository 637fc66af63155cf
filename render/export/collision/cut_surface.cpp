#include "render/export/collision/cut_surface.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

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

}  // namespace

double CutSurface::volume() const {
  const glm::dvec3 middle = skin.empty() ? glm::dvec3(0) : skin.front()[0];
  double six_times = 0;
  for (const std::vector<Corners>* list : {&skin, &cones})
    for (const Corners& t : *list) six_times += glm::dot(t[0] - middle, glm::cross(t[1] - middle, t[2] - middle));
  return six_times / 6;
}

std::vector<glm::vec3> CutSurface::points() const {
  std::vector<glm::vec3> all;
  for (const Corners& triangle : skin)
    for (const glm::dvec3& p : triangle) all.emplace_back(p);
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
  return {std::move(behind).surface(), std::move(before).surface()};
}

}  // namespace pomona::collision
