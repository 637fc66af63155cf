// Where a fruit and a closed knife lie to each other, without ties: exact signs, and where a sign is zero, the one the
// knife would have if it stood the least bit off its place, by (e, e^2, e^3) for a vanishing e. The whole knife moves
// as one, so that all answers fit together: what is cut is a knife that touches nothing without crossing it.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace pomona {

using Corners = std::array<glm::dvec3, 3>;

/// +1 where the triangle's corners are seen to run counter-clockwise, -1 on the other side. 1 for one without area.
int side_of_knife(const Corners& knife, const glm::dvec3& fruit_point);
int side_of_fruit(const Corners& fruit, const glm::dvec3& knife_point);

/// The sign of det(q - p, a - p, b - p): the sense in which the knife's edge ab passes the fruit's edge pq. 0 only for
/// edges that are parallel.
int turn(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b);

/// What the triangle adds to how often its mesh winds around the point: +1, -1 or 0.
int winding_of_knife(const Corners& knife, const glm::dvec3& fruit_point);
int winding_of_fruit(const Corners& fruit, const glm::dvec3& knife_point);

}  // namespace pomona
