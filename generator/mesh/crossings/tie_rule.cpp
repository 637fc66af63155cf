#include "generator/mesh/crossings/tie_rule.h"

#include <algorithm>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

namespace pomona {

namespace {

using InexactKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;

InexactKernel::Point_3 to_point(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

int sign_of(CGAL::Sign sign) { return static_cast<int>(sign); }

int orientation(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s) {
  return sign_of(CGAL::orientation(to_point(p), to_point(q), to_point(r), to_point(s)));
}

using ExactVector = std::array<Exact, 3>;

ExactVector way(const glm::dvec3& from, const glm::dvec3& to) {
  return {Exact(to.x) - Exact(from.x), Exact(to.y) - Exact(from.y), Exact(to.z) - Exact(from.z)};
}

/// Six times the volume between the triangle and a vector from its first corner.
Exact volume(const Corners& t, const ExactVector& w) {
  const ExactVector u = way(t[0], t[1]), v = way(t[0], t[2]);
  return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] + (u[0] * v[1] - u[1] * v[0]) * w[2];
}

/// The share of the segment from p to q at which it passes through the triangle's plane; 0 if it is parallel.
Exact share_along(const glm::dvec3& p, const glm::dvec3& q, const Corners& t) {
  const Exact before = volume(t, way(t[0], p)), after = volume(t, way(t[0], q));
  return before == after ? Exact(0) : Exact(before / (before - after));
}

/// The sign of the triangle's normal along an axis.
int normal_sign(const Corners& t, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto flat = [&](const glm::dvec3& p) { return InexactKernel::Point_2(p[u], p[v]); };
  return sign_of(CGAL::orientation(flat(t[0]), flat(t[1]), flat(t[2])));
}

/// The side of the triangle on which the point lies. `sense` is 1 where the point moves by (e, e^2, e^3), -1 where the
/// triangle does.
int side(const Corners& t, const glm::dvec3& p, int sense) {
  const int exact = orientation(t[0], t[1], t[2], p);
  if (exact != 0) return exact;
  for (int axis = 0; axis < 3; ++axis) {
    const int sign = normal_sign(t, axis);
    if (sign != 0) return sense * sign;
  }
  return 1;
}

/// The side of the segment from a to b on which the point lies, seen from above; 0 only for a vertical segment.
int side_of_way(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p, int sense) {
  const auto flat = [](const glm::dvec3& q) { return InexactKernel::Point_2(q.z, q.x); };
  const int exact = sign_of(CGAL::orientation(flat(a), flat(b), flat(p)));
  if (exact != 0) return exact;
  if (a.z != b.z) return sense * (a.z < b.z ? 1 : -1);
  if (a.x != b.x) return sense * (a.x < b.x ? -1 : 1);
  return 0;
}

/// The winding that the ray from the point upwards counts. Far from the triangle's shadow it need not be exact.
int winding(const Corners& t, const glm::dvec3& p, int sense) {
  for (const int axis : {0, 2}) {
    const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
    if (p[axis] < low || p[axis] > high) return 0;
  }
  const int around = side_of_way(t[0], t[1], p, sense);
  if (around == 0 || side_of_way(t[1], t[2], p, sense) != around || side_of_way(t[2], t[0], p, sense) != around) {
    return 0;
  }
  return side(t, p, sense) == -around ? around : 0;
}

}  // namespace

int side_of_knife(const Corners& knife, const glm::dvec3& fruit_point) { return side(knife, fruit_point, -1); }
int side_of_fruit(const Corners& fruit, const glm::dvec3& knife_point) { return side(fruit, knife_point, 1); }

int turn(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& a, const glm::dvec3& b) {
  const int exact = orientation(p, q, a, b);
  if (exact != 0) return exact;

  // As the knife moves by d, the determinant changes by dot(d, cross(q - p, a - b)).
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const Exact left = (Exact(q[u]) - Exact(p[u])) * (Exact(a[v]) - Exact(b[v]));
    const Exact right = (Exact(q[v]) - Exact(p[v])) * (Exact(a[u]) - Exact(b[u]));
    if (left != right) return left > right ? 1 : -1;
  }
  return 0;
}

int order_along(const glm::dvec3& p, const glm::dvec3& q, const Corners& one, const Corners& other) {
  const Exact first = share_along(p, q, one), second = share_along(p, q, other);
  return first < second ? -1 : second < first ? 1 : 0;
}

int winding_of_knife(const Corners& knife, const glm::dvec3& fruit_point) { return winding(knife, fruit_point, -1); }
int winding_of_fruit(const Corners& fruit, const glm::dvec3& knife_point) { return winding(fruit, knife_point, 1); }

}  // namespace pomona
