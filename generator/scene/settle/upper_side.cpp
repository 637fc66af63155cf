#include "generator/scene/settle/upper_side.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

UpperSide::UpperSide(const TriangleTree& mesh, const MeshDish* form) {
  constexpr double min_slope = 0.2;
  for (const TriangleTree::Corners& t : mesh.triangles()) {
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    const double twice_area = glm::length(normal);
    if (!(normal.y > min_slope * twice_area)) continue;
    // Triangles below others are no upper side.
    const glm::dvec3 middle = (t[0] + t[1] + t[2]) / 3.0;
    if (form == nullptr || middle.y < form->box().low.y - 1e-9 || !form->covers(middle.x, middle.z)) continue;
    if (mesh.height_below({middle.x + 1e-7, form->box().high.y + 1, middle.z + 1e-7}) > middle.y + 1e-4) continue;
    corners_.push_back(t);
    area_.push_back((area_.empty() ? 0 : area_.back()) + 0.5 * twice_area);
  }
}
UpperSide::Spot UpperSide::spot(double share, double u, double v) const {
  const auto found = std::upper_bound(area_.begin(), area_.end(), share * area_.back());
  const TriangleTree::Corners& t = corners_[static_cast<std::size_t>(std::min(found, area_.end() - 1) - area_.begin())];
  const double root = std::sqrt(u);  // even over the triangle
  return {(1 - root) * t[0] + root * (1 - v) * t[1] + root * v * t[2],
          glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]))};
}

}  // namespace pomona
