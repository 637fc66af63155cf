#include "render/compare/flip_color.h"

#include <cmath>

#include <glm/matrix.hpp>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

// XYZ of linear sRGB, by columns. The rows' sums are the white that FLIP's published figures were made with,
// (0.950428545, 1, 1.088900371); it differs in the fifth digit from the one of the standard.
const glm::dmat3 xyz_from_linear(10135552.0 / 24577794.0, 2613072.0 / 12288897.0, 1425312.0 / 73733382.0,
                                 8788810.0 / 24577794.0, 8788810.0 / 12288897.0, 8788810.0 / 73733382.0,
                                 4435075.0 / 24577794.0, 887015.0 / 12288897.0, 70074185.0 / 73733382.0);
const glm::dvec3 white = xyz_from_linear * glm::dvec3(1);
const glm::dmat3 linear_from_xyz = glm::inverse(xyz_from_linear);

/// CIELAB's cube root, with its straight piece near black.
double lab_curve(double t) {
  constexpr double delta = 6.0 / 29.0;
  return t > delta * delta * delta ? reproducible::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29.0;
}

}  // namespace

glm::dvec3 opponent_from_linear(const glm::dvec3& rgb) {
  const glm::dvec3 share = xyz_from_linear * rgb / white;
  return {116 * share.y - 16, 500 * (share.x - share.y), 200 * (share.y - share.z)};
}

glm::dvec3 linear_from_opponent(const glm::dvec3& opponent) {
  const double y = (opponent.x + 16) / 116;
  return linear_from_xyz * (glm::dvec3(y + opponent.y / 500, y, y - opponent.z / 200) * white);
}

glm::dvec3 hunt_lab_from_linear(const glm::dvec3& rgb) {
  const glm::dvec3 share = xyz_from_linear * rgb / white;
  const glm::dvec3 root(lab_curve(share.x), lab_curve(share.y), lab_curve(share.z));
  const double lightness = 116 * root.y - 16;
  return {lightness, 0.01 * lightness * 500 * (root.x - root.y), 0.01 * lightness * 200 * (root.y - root.z)};
}

double hyab(const glm::dvec3& first, const glm::dvec3& second) {
  const glm::dvec3 d = first - second;
  return std::fabs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

double luminance_of_linear(const glm::dvec3& rgb) { return (opponent_from_linear(rgb).x + 16) / 116; }

}  // namespace pomona
