#include "generator/mesh/triangle_distance.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

double squared(const glm::dvec3& v) { return glm::dot(v, v); }

/// The place where the segment passes through the triangle's inside, if it does.
std::optional<glm::dvec3> crossing(const glm::dvec3& from, const glm::dvec3& to, const TriangleCorners& t) {
  const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double above = glm::dot(normal, from - t[0]);
  const double below = glm::dot(normal, to - t[0]);
  if ((above > 0) == (below > 0) || above == below) return std::nullopt;
  const glm::dvec3 point = from + (to - from) * (above / (above - below));
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& a = t[static_cast<std::size_t>(i)];
    const glm::dvec3& b = t[static_cast<std::size_t>((i + 1) % 3)];
    if (glm::dot(glm::cross(b - a, point - a), normal) < 0) return std::nullopt;
  }
  return point;
}

}  // namespace

glm::dvec3 nearest_on_triangle(const glm::dvec3& p, const TriangleCorners& t) {
  const glm::dvec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = p - t[0];
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0 && d2 <= 0) return t[0];

  const glm::dvec3 bp = p - t[1];
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0 && d4 <= d3) return t[1];
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) return t[0] + ab * (d1 / (d1 - d3));

  const glm::dvec3 cp = p - t[2];
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0 && d5 <= d6) return t[2];
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) return t[0] + ac * (d2 / (d2 - d6));

  const double va = d3 * d6 - d5 * d4;
  const double along_bc = (d4 - d3) + (d5 - d6);
  if (va <= 0 && d4 >= d3 && d5 >= d6 && along_bc > 0) return t[1] + (t[2] - t[1]) * ((d4 - d3) / along_bc);

  const double sum = va + vb + vc;
  if (!(sum > 0)) return t[0];  // no area
  return t[0] + ab * (vb / sum) + ac * (vc / sum);
}

std::array<glm::dvec3, 2> nearest_on_segments(const glm::dvec3& p0, const glm::dvec3& p1, const glm::dvec3& q0,
                                              const glm::dvec3& q1) {
  const glm::dvec3 d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
  const double a = glm::dot(d1, d1), e = glm::dot(d2, d2), f = glm::dot(d2, r);
  double s = 0, t = 0;
  if (a <= 0 && e <= 0) return {p0, q0};
  if (a <= 0) {
    t = std::clamp(f / e, 0.0, 1.0);
  } else {
    const double c = glm::dot(d1, r);
    if (e <= 0) {
      s = std::clamp(-c / a, 0.0, 1.0);
    } else {
      const double b = glm::dot(d1, d2), denominator = a * e - b * b;
      if (denominator > 0) s = std::clamp((b * f - c * e) / denominator, 0.0, 1.0);
      t = (b * s + f) / e;
      if (t < 0) {
        t = 0;
        s = std::clamp(-c / a, 0.0, 1.0);
      } else if (t > 1) {
        t = 1;
        s = std::clamp((b - c) / a, 0.0, 1.0);
      }
    }
  }
  return {p0 + d1 * s, q0 + d2 * t};
}

std::array<glm::dvec3, 2> nearest_on_triangles(const TriangleCorners& a, const TriangleCorners& b) {
  std::array<glm::dvec3, 2> best{};
  double best_squared = std::numeric_limits<double>::infinity();
  const auto offer = [&](const glm::dvec3& p, const glm::dvec3& q) {
    const double d = squared(p - q);
    if (d < best_squared) best_squared = d, best = {p, q};
  };

  for (std::size_t i = 0; i < 3; ++i) {
    if (const auto point = crossing(a[i], a[(i + 1) % 3], b)) return {*point, *point};
    if (const auto point = crossing(b[i], b[(i + 1) % 3], a)) return {*point, *point};
    offer(a[i], nearest_on_triangle(a[i], b));
    offer(nearest_on_triangle(b[i], a), b[i]);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto pair = nearest_on_segments(a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]);
      offer(pair[0], pair[1]);
    }
  }
  return best;
}

}  // namespace pomona
