#include "render/thumbnail/projection.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

Projection::Projection(const View& view, int side) : frame_(view_frame(view)), eye_(view.eye), middle_(0.5 * side) {
  const double half = 0.5 * view.vertical_field;
  scale_ = middle_ * reproducible::cos(half) / reproducible::sin(half);
}

ProjectedPoint Projection::operator()(const glm::dvec3& point) const {
  // In a fitted view nothing is nearer than a thousandth of the distance to the target.
  const glm::dvec3 seen = point - eye_;
  const double depth = std::max(-glm::dot(seen, frame_.back), 1e-3 * frame_.distance);
  const double nearness = 1 / depth;
  return {middle_ + scale_ * nearness * glm::dot(seen, frame_.right),
          middle_ - scale_ * nearness * glm::dot(seen, frame_.up), nearness};
}

}  // namespace pomona
