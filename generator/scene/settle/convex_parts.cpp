#include "generator/scene/settle/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/mesh/convex_hull.h"

namespace pomona {

namespace {

using Corners = TriangleTree::Corners;

struct Plane {
  glm::dvec3 normal{0}, point{0};
  double above(const glm::dvec3& p) const { return glm::dot(normal, p - point); }
};

/// What lies on one side of all planes so far, the hull of it, and where that reaches farthest out of the solid.
struct Part {
  std::vector<Corners> surface;
  ConvexHull hull;
  double reach = 0;
  glm::dvec3 farthest{0};
};

/// The side of the surface where the plane's function is positive. The hull of what it leaves equals that of
/// the solid's half: the corners of a cut solid are its own and those where the plane cuts an edge.
std::vector<Corners> clipped(const std::vector<Corners>& surface, const Plane& plane) {
  std::vector<Corners> kept;
  for (const Corners& t : surface) {
    std::vector<glm::dvec3> polygon;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 &a = t[i], &b = t[(i + 1) % 3];
      const double above_a = plane.above(a), above_b = plane.above(b);
      if (above_a >= 0) polygon.push_back(a);
      if ((above_a > 0 && above_b < 0) || (above_a < 0 && above_b > 0))
        polygon.push_back(a + (b - a) * (above_a / (above_a - above_b)));
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) kept.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
  return kept;
}

/// Points in almost one place count once: of each cell of a grid the first in order stays.
std::vector<glm::dvec3> thinned(const std::vector<Corners>& surface, double spacing) {
  using Cell = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  std::vector<std::pair<Cell, glm::dvec3>> cells;
  for (const Corners& t : surface) {
    for (const glm::dvec3& p : t) {
      const glm::dvec3 c = glm::floor(p / spacing);
      cells.push_back(
          {{static_cast<std::int64_t>(c.x), static_cast<std::int64_t>(c.y), static_cast<std::int64_t>(c.z)}, p});
    }
  }
  std::sort(cells.begin(), cells.end(), [](const auto& a, const auto& b) {
    return std::tie(a.first, a.second.x, a.second.y, a.second.z) <
           std::tie(b.first, b.second.x, b.second.y, b.second.z);
  });
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (i == 0 || cells[i].first != cells[i - 1].first) points.push_back(cells[i].second);
  return points;
}

class Decomposition {
 public:
  Decomposition(const TriangleTree& solid, const ConvexPartsOptions& options)
      : solid_(solid), options_(options), size_(glm::length(solid.box().high - solid.box().low)) {}

  std::vector<ConvexPart> run() {
    std::vector<Part> parts{made(solid_.triangles())};
    while (static_cast<int>(parts.size()) < options_.most) {
      // Take the part that reaches farthest out of the solid.
      const auto worst =
          std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.reach < b.reach; });
      if (worst->reach <= options_.tolerance * size_) break;
      auto halves = halved(*worst);
      if (halves.empty()) {
        worst->reach = 0;  // no plane makes it smaller
        continue;
      }
      *worst = std::move(halves[0]);
      parts.push_back(std::move(halves[1]));
    }

    std::vector<ConvexPart> corners;
    for (const Part& part : parts) corners.push_back(part.hull.point);
    return corners;
  }

 private:
  Part made(std::vector<Corners> surface) const {
    Part part;
    part.hull = convex_hull(thinned(surface, options_.corner * size_));
    part.surface = std::move(surface);
    measure(part);
    return part;
  }

  /// Looks at points spread over the hull's faces for the one farthest outside the solid.
  void measure(Part& part) const {
    const double spacing = size_ / 32;
    for (const glm::uvec3& t : part.hull.triangle) {
      const glm::dvec3 &a = part.hull.point[t.x], &b = part.hull.point[t.y], &c = part.hull.point[t.z];
      const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
      const int steps = static_cast<int>(std::ceil(longest / spacing)) + 1;
      for (int i = 0; i <= steps; ++i) {
        for (int j = 0; i + j <= steps; ++j) {
          const glm::dvec3 p = a + (b - a) * (double(i) / steps) + (c - a) * (double(j) / steps);
          offer(part, p);
        }
      }
    }
  }

  void offer(Part& part, const glm::dvec3& p) const {
    if (solid_.nearest(p, std::max(part.reach, 0.25 * options_.tolerance * size_)).distance <= part.reach) return;
    if (solid_.contains(p)) return;
    const double distance = solid_.nearest(p).distance;
    if (distance > part.reach) part.reach = distance, part.farthest = p;
  }

  /// By the plane, of five through the farthest point, that leaves the smallest hulls; none if they all leave
  /// one side empty.
  std::vector<Part> halved(const Part& part) const {
    const double slope = std::sqrt(0.5);
    std::vector<Part> best;
    double best_volume = volume(part.hull) * (1 - 1e-9);
    for (const glm::dvec3& normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                     glm::dvec3(slope, 0, slope), glm::dvec3(slope, 0, -slope)}) {
      std::vector<Part> halves(2);
      double sum = 0;
      for (const int side : {0, 1}) {
        Part& half = halves[static_cast<std::size_t>(side)];
        half.surface = clipped(part.surface, {side == 0 ? normal : -normal, part.farthest});
        half.hull = convex_hull(thinned(half.surface, options_.corner * size_));
        sum += volume(half.hull);
      }
      if (sum >= best_volume || halves[0].hull.triangle.empty() || halves[1].hull.triangle.empty()) continue;
      best_volume = sum;
      best = std::move(halves);
    }
    for (Part& half : best) measure(half);
    return best;
  }

  const TriangleTree& solid_;
  ConvexPartsOptions options_;
  double size_;
};

}  // namespace

std::vector<ConvexPart> convex_parts(const TriangleTree& solid, const ConvexPartsOptions& options) {
  if (solid.empty()) return {};
  return Decomposition(solid, options).run();
}

}  // namespace pomona
