#include "generator/diffusion/nearest_side.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// The best so far on the way through the tree.
class Search {
 public:
  Search(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const glm::dvec3& point, double radius)
      : surfaces_(surfaces), tree_(tree), point_(point), limit_(radius), tie_(1e-12 * tree.size) {}

  std::optional<SurfaceSide> run() {
    visit(tree_.levels.size() - 1, 0);
    return best_;
  }

 private:
  void visit(std::size_t level, std::size_t index) {
    if (level == 0) {
      const auto [first, end] = leaf(tree_, index);
      for (std::size_t i = first; i < end; ++i) try_triangle(tree_.order[i]);
      return;
    }
    const NearestChildren inside = nearest_children(tree_, level, index, point_, squared_limit());
    for (std::size_t i = 0; i < inside.count && inside.child[i].first <= squared_limit(); ++i) {
      visit(level - 1, inside.child[i].second);
    }
  }

  void try_triangle(std::uint32_t triangle) {
    const auto [a, b, c] = corners(surfaces_, triangle);
    if (squared_distance(box_around(a, b, c), point_) > squared_limit()) return;
    const glm::dvec3 place = nearest_on_triangle(point_, a, b, c);
    const double distance = glm::length(point_ - (place.x * a + place.y * b + place.z * c));
    if (distance > limit_ + tie_) return;

    const double height = glm::dot(point_ - a, glm::normalize(glm::cross(b - a, c - a)));
    const double squareness = std::fabs(height);
    const bool ties = best_ && distance >= best_->distance - tie_;
    if (ties && (squareness < squareness_ || (squareness == squareness_ && triangle > best_->triangle))) return;
    limit_ = std::min(limit_, distance);
    squareness_ = squareness;
    best_ = SurfaceSide{triangle, height < 0 ? SideOf::back : SideOf::front, place, distance};
  }

  double squared_limit() const { return (limit_ + tie_) * (limit_ + tie_); }

  const DiffusionSurfaces& surfaces_;
  const SurfaceTree& tree_;
  glm::dvec3 point_;
  double limit_;  ///< the least distance met so far, at most the radius
  double tie_;    ///< distances closer than this are the same one, rounded differently
  double squareness_ = 0;
  std::optional<SurfaceSide> best_;
};

}  // namespace

glm::dvec3 nearest_on_triangle(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a;

  // At a, at b, or on the edge between them.
  const double d1 = glm::dot(ab, p - a), d2 = glm::dot(ac, p - a);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const double d3 = glm::dot(ab, p - b), d4 = glm::dot(ac, p - b);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const double on_c = d1 * d4 - d3 * d2;
  if (on_c <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};

  // At c, or on the edges that meet there.
  const double d5 = glm::dot(ab, p - c), d6 = glm::dot(ac, p - c);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double on_b = d5 * d2 - d1 * d6;
  if (on_b <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const double on_a = d3 * d6 - d5 * d4;
  if (on_a <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }

  // Inside.
  const double sum = on_a + on_b + on_c;
  return {1 - on_b / sum - on_c / sum, on_b / sum, on_c / sum};
}

std::optional<SurfaceSide> nearest_side(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                        const glm::dvec3& point, double radius) {
  return Search(surfaces, tree, point, radius).run();
}

glm::dvec3 color_of(const DiffusionSurfaces& surfaces, const SurfaceSide& at) {
  const glm::uvec3& t = surfaces.triangle[at.triangle];
  const std::vector<Color>& color = at.side == SideOf::front ? surfaces.front_color : surfaces.back_color;
  return at.barycentric.x * glm::dvec3(color[t.x]) + at.barycentric.y * glm::dvec3(color[t.y]) +
         at.barycentric.z * glm::dvec3(color[t.z]);
}

std::int32_t part_of(const DiffusionSurfaces& surfaces, const SurfaceSide& at) {
  return (at.side == SideOf::front ? surfaces.front_part : surfaces.back_part)[at.triangle];
}

}  // namespace pomona
