// The position of a fruit and a closed knife to each other, without ties. Signs are exact. Where a sign is zero, it is
// the sign for a knife that is moved by (e, e^2, e^3), with e infinitely small. The whole knife moves in the same way,
// so all answers are consistent: the knife touches nothing without crossing it.
#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace pomona {

using Corners = std::array<glm::dvec3, 3>;

/// +1 if the triangle's corners run counter-clockwise seen from the point, else -1. 1 for a triangle of area 0.
int side_of_knife(const Corners& knife, const glm::dvec3& fruit_point);
int side_of_fruit(const Corners& fruit, const glm::dvec3& knife_point);

/// The sign of det(q - p, a - p, b - p): the sense in which the knife's edge ab passes the fruit's edge pq. 0 only for
/// edges that are parallel.
int turn(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b);

/// In which order the way from p to q passes through the planes of two triangles: -1, 1, or 0 for one place. Exact; the
/// tie rule does not decide here.
int order_along(const glm::dvec3& p, const glm::dvec3& q, const Corners& one, const Corners& other);

/// The contribution of the triangle to the winding number of its mesh around the point: +1, -1 or 0.
int winding_of_knife(const Corners& knife, const glm::dvec3& fruit_point);
int winding_of_fruit(const Corners& fruit, const glm::dvec3& knife_point);

}  // namespace pomona
