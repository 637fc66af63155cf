#include "generator/compose/reach_table.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// A direction on the cube: its face, two for each axis, and where on it, -1..1.
struct CubePlace {
  int face = 0;
  double u = 0, v = 0;
};

int axis_of(int face) { return face / 2; }
double sign_of(int face) { return face % 2 == 0 ? 1 : -1; }

/// A direction as seen on a face: two across, one towards it.
glm::dvec3 on_face(const glm::dvec3& d, int face) {
  const int k = axis_of(face);
  return {d[(k + 1) % 3], d[(k + 2) % 3], sign_of(face) * d[k]};
}

glm::dvec3 direction_at(int face, double u, double v) {
  glm::dvec3 d(0);
  const int k = axis_of(face);
  d[k] = sign_of(face);
  d[(k + 1) % 3] = u;
  d[(k + 2) % 3] = v;
  return d;
}

CubePlace place_on_cube(const glm::dvec3& d) {
  const glm::dvec3 size = glm::abs(d);
  const int k = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int face = 2 * k + (d[k] < 0 ? 1 : 0);
  const glm::dvec3 seen = on_face(d, face);
  return {face, seen.x / seen.z, seen.y / seen.z};
}

/// How many times a direction goes from the origin to a triangle [Moeller and Trumbore 1997]; nothing beside it.
std::optional<double> way_to(const std::array<glm::dvec3, 3>& corner, const glm::dvec3& direction) {
  const glm::dvec3 a = corner[1] - corner[0], b = corner[2] - corner[0], h = glm::cross(direction, b);
  const double det = glm::dot(a, h);
  if (det == 0) return {};
  const double u = -glm::dot(corner[0], h) / det;
  const glm::dvec3 q = glm::cross(-corner[0], a);
  const double v = glm::dot(direction, q) / det, way = glm::dot(b, q) / det;
  constexpr double rim = 1e-9;
  if (u < -rim || v < -rim || u + v > 1 + rim || way <= 0) return {};
  return way;
}

}  // namespace

ReachTable::ReachTable(const DiffusionSurfaces& surfaces, std::int32_t skin, const glm::dvec3& heart) : heart_(heart) {
  double corners = 0;
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    if (surfaces.surface[t] != skin || surfaces.instance_of(t) != 0) continue;
    std::array<glm::dvec3, 3> corner{};
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 way = glm::dvec3(surfaces.position[surfaces.triangle[t][k]]) - heart;
      corner[static_cast<std::size_t>(k)] = way;
      spread_ += glm::dmat3(way * way.x, way * way.y, way * way.z);
      corners += 1;
    }
    for (int face = 0; face < 6; ++face) add(corner, face);
  }
  if (corners > 0) spread_ /= corners;
  for (const Face& face : reach_) {
    for (const double reach : face) closed_ = closed_ && reach > 0;
  }
}

void ReachTable::add(const std::array<glm::dvec3, 3>& corner, int face) {
  // Most triangles lie wholly beyond one of the planes through the heart that bound the face, or behind the heart.
  const std::array<glm::dvec3, 3> seen{on_face(corner[0], face), on_face(corner[1], face), on_face(corner[2], face)};
  constexpr double rim = 1.001;  // a little more than the face, for rounding
  const auto all = [&](const auto& holds) { return std::all_of(seen.begin(), seen.end(), holds); };
  if (all([](const glm::dvec3& p) { return p.z <= 0; })) return;
  for (const int axis : {0, 1}) {
    if (all([&](const glm::dvec3& p) { return p[axis] > rim * p.z; })) return;
    if (all([&](const glm::dvec3& p) { return -p[axis] > rim * p.z; })) return;
  }

  // The nodes behind the triangle's box on the face; all of them where it reaches beyond the face's half of space.
  glm::dvec2 low(2), high(-2);
  int behind = 0;
  for (const glm::dvec3& p : seen) {
    if (!(p.z > 1e-3 * glm::length(p))) {
      ++behind;
      continue;
    }
    low = glm::min(low, glm::dvec2(p) / p.z);
    high = glm::max(high, glm::dvec2(p) / p.z);
  }
  if (behind == 3) return;
  if (behind > 0) low = glm::dvec2(-1), high = glm::dvec2(1);
  if (low.x > 1 || low.y > 1 || high.x < -1 || high.y < -1) return;
  // A little beside the box for rounding: most triangles are smaller than a cell, and lie between nodes.
  constexpr double slack = 1e-3;  // cells
  const auto first = [](double v) { return std::max(0, static_cast<int>(std::ceil((v + 1) * 0.5 * cells - slack))); };
  const auto last = [](double v) {
    return std::min(cells, static_cast<int>(std::floor((v + 1) * 0.5 * cells + slack)));
  };
  for (int j = first(low.y); j <= last(high.y); ++j) {
    for (int i = first(low.x); i <= last(high.x); ++i) {
      const glm::dvec3 d = glm::normalize(direction_at(face, 2.0 * i / cells - 1, 2.0 * j / cells - 1));
      const std::optional<double> way = way_to(corner, d);
      if (!way) continue;
      double& reach = reach_[static_cast<std::size_t>(face)][static_cast<std::size_t>(j * nodes + i)];
      reach = std::max(reach, *way);
      farthest_ = std::max(farthest_, *way);
    }
  }
}

double ReachTable::along(const glm::dvec3& direction) const {
  const CubePlace at = place_on_cube(direction);
  const double x = (at.u + 1) * 0.5 * cells, y = (at.v + 1) * 0.5 * cells;
  const int i = std::clamp(static_cast<int>(x), 0, cells - 1), j = std::clamp(static_cast<int>(y), 0, cells - 1);
  const Face& face = reach_[static_cast<std::size_t>(at.face)];
  const auto node = [&](int a, int b) { return face[static_cast<std::size_t>(b * nodes + a)]; };
  const double a = x - i, b = y - j;
  return (1 - b) * ((1 - a) * node(i, j) + a * node(i + 1, j)) +
         b * ((1 - a) * node(i, j + 1) + a * node(i + 1, j + 1));
}

}  // namespace pomona
