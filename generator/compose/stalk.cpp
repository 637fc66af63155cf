#include "generator/compose/stalk.h"

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr int rings = 7;
constexpr double sag = 0.08;  // of its length

/// Rings of vertices along a path, and a pole at either end.
class Tube {
 public:
  explicit Tube(const StalkSketch& stalk) : stalk_(stalk) {}

  DiffusionSurfaces between(const glm::dvec3& root, const glm::dvec3& top) {
    const glm::dvec3 middle = 0.5 * (root + top) - glm::dvec3(0, sag * glm::length(top - root), 0);
    for (int i = 0; i < rings; ++i) {
      const double u = i / (rings - 1.0);
      const glm::dvec3 along = 2 * (1 - u) * (middle - root) + 2 * u * (top - middle);
      add_ring((1 - u) * (1 - u) * root + 2 * u * (1 - u) * middle + u * u * top, along,
               0.5 * (stalk_.root_width + u * (stalk_.top_width - stalk_.root_width)));
    }
    add_pole(root - (middle - root) * (0.25 * stalk_.root_width / glm::length(middle - root)));
    add_pole(top + (top - middle) * (0.25 * stalk_.top_width / glm::length(top - middle)));
    add_walls();
    return std::move(tube_);
  }

 private:
  void add_vertex(const glm::dvec3& p) {
    tube_.position.emplace_back(p);
    tube_.front_color.push_back(stalk_.color);
    tube_.back_color.push_back(stalk_.color);
    tube_.blur.push_back(0);
    tube_.front_hidden.push_back(1);
    tube_.back_hidden.push_back(0);
  }

  void add_pole(const glm::dvec3& p) { add_vertex(p); }

  /// Across the path, each ring turned as little as can be from the one before.
  void add_ring(const glm::dvec3& center, const glm::dvec3& along, double radius) {
    const glm::dvec3 axis = glm::normalize(along);
    if (side_ == glm::dvec3(0)) side_ = std::fabs(axis.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    side_ = glm::normalize(side_ - glm::dot(side_, axis) * axis);
    const glm::dvec3 other = glm::cross(axis, side_);
    for (int k = 0; k < stalk_.around; ++k) {
      const double angle = 2 * pi * k / stalk_.around;
      add_vertex(center + radius * (reproducible::cos(angle) * side_ + reproducible::sin(angle) * other));
    }
  }

  void add_walls() {
    const auto n = static_cast<std::uint32_t>(stalk_.around);
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t next = (k + 1) % n, last = (rings - 1) * n;
      add_triangle(rings * n, next, k);
      for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
        add_triangle(ring * n + k, ring * n + next, (ring + 1) * n + next);
        add_triangle(ring * n + k, (ring + 1) * n + next, (ring + 1) * n + k);
      }
      add_triangle(rings * n + 1, last + k, last + next);
    }
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    tube_.triangle.emplace_back(a, b, c);
    tube_.surface.push_back(0);
    tube_.front_part.push_back(0);
    tube_.back_part.push_back(0);
  }

  const StalkSketch& stalk_;
  glm::dvec3 side_{0};
  DiffusionSurfaces tube_;
};

}  // namespace

DiffusionSurfaces stalk_between(const StalkSketch& stalk, const std::string& part, const glm::dvec3& root,
                                const glm::dvec3& top) {
  DiffusionSurfaces tube = Tube(stalk).between(root, top);
  tube.surface_names = {"stalk"};
  tube.part_names = {part};
  return tube;
}

}  // namespace pomona
