#include "generator/piece/lod/piece_cover.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace pomona {
namespace {

bool is_inside(const Box<double>& box, const glm::dvec3& p) {
  return (p.x >= box.low.x) & (p.y >= box.low.y) & (p.z >= box.low.z) & (p.x <= box.high.x) & (p.y <= box.high.y) &
         (p.z <= box.high.z);
}

bool is_near(const glm::dvec3& p, const CoveringTriangle& near, double bound) {
  if (!is_inside(near.reach, p)) return false;
  const glm::dvec3 away = nearest_on_triangle(p, near.corner) - p;
  return glm::dot(away, away) <= bound * bound;
}

}  // namespace

CoveringTriangle covering_triangle(const TriangleCorners& c, double bound) {
  Box<double> reach = box_around(c[0], c[1], c[2]);
  reach.low -= bound, reach.high += bound;
  return {c, reach};
}

bool is_covered(const TriangleCorners& piece, std::span<const CoveringTriangle> near, double bound, int quarterings) {
  const auto is_whole_near = [&](const CoveringTriangle& n) {
    return is_near(piece[0], n, bound) && is_near(piece[1], n, bound) && is_near(piece[2], n, bound);
  };
  if (std::any_of(near.begin(), near.end(), is_whole_near)) return true;
  const glm::dvec3 middle = (piece[0] + piece[1] + piece[2]) / 3.0;
  const auto is_middle_near = [&](const CoveringTriangle& n) { return is_near(middle, n, bound); };
  if (quarterings == 0 || std::none_of(near.begin(), near.end(), is_middle_near)) return false;
  const glm::dvec3 ab = 0.5 * (piece[0] + piece[1]), bc = 0.5 * (piece[1] + piece[2]), ca = 0.5 * (piece[2] + piece[0]);
  return is_covered({ab, bc, ca}, near, bound, quarterings - 1) &&
         is_covered({piece[0], ab, ca}, near, bound, quarterings - 1) &&
         is_covered({ab, piece[1], bc}, near, bound, quarterings - 1) &&
         is_covered({ca, bc, piece[2]}, near, bound, quarterings - 1);
}

}  // namespace pomona
