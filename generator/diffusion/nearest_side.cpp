#include "generator/diffusion/nearest_side.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"

namespace pomona {

namespace {

/// The best so far on the way through the tree.
class SideSearch {
 public:
  SideSearch(const DiffusionSurfaces& surfaces, const SurfaceTree& tree, const glm::dvec3& point, double radius)
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
    const glm::dvec3 place = nearest_weights(point_, a, b, c);
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

std::optional<SurfaceSide> nearest_side(const DiffusionSurfaces& surfaces, const SurfaceTree& tree,
                                        const glm::dvec3& point, double radius) {
  return SideSearch(surfaces, tree, point, radius).run();
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
