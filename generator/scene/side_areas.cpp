#include "generator/scene/side_areas.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/mesh/box.h"

namespace pomona {

SideAreas::SideAreas(const Solid& solid) {
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const glm::dvec3 vector = 0.5 * solid.mesh.area_vector(t);
    const double area = glm::length(vector);
    if (!(area > 0)) continue;
    const bool is_cut = solid.mesh.cut_face[t] >= 0;
    (is_cut ? cut_by_ : skin_by_)[bin(vector)] += vector;
    (is_cut ? cut_ : skin_) += area;
  }
}

std::size_t SideAreas::bin(const glm::dvec3& direction) {
  const int axis = longest_axis(glm::abs(direction));
  const auto cell = [&](int other) {
    const double place = 0.5 * (1 + direction[other] / std::fabs(direction[axis]));
    return std::min(static_cast<std::size_t>(place * across), across - 1);
  };
  const std::size_t side = 2 * static_cast<std::size_t>(axis) + (direction[axis] < 0 ? 1 : 0);
  return (side * across + cell((axis + 1) % 3)) * across + cell((axis + 2) % 3);
}

SideAreas::Seen SideAreas::from(const glm::dvec3& direction) const {
  Seen seen;
  for (std::size_t i = 0; i < count; ++i) {
    seen.cut += std::max(0.0, glm::dot(cut_by_[i], direction));
    seen.skin += std::max(0.0, glm::dot(skin_by_[i], direction));
  }
  return seen;
}

}  // namespace pomona
