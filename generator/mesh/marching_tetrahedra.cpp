#include "generator/mesh/marching_tetrahedra.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pomona {

namespace {

using Tetrahedron = LevelSurface::Tetrahedron;

/// Smallest share of an edge between an end and the point that splits it: a level moves by less than this part of a
/// cell, so that no part becomes so thin that rounding could turn it over.
constexpr double min_share = 0.03;

std::array<glm::uvec3, 4> outward_faces(const Tetrahedron& t) {
  return {glm::uvec3(t[1], t[2], t[3]), {t[0], t[3], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[1]}};
}

std::array<std::uint32_t, 3> sorted(const glm::uvec3& face) {
  std::array<std::uint32_t, 3> s{face.x, face.y, face.z};
  std::sort(s.begin(), s.end());
  return s;
}

/// The same but for whole periods, next to 0.
double within(double value, double period) { return period > 0 ? value - period * std::round(value / period) : value; }

}  // namespace

std::uint32_t LevelSurface::add_vertex(const glm::dvec3& place, const Values& values) {
  place_.push_back(place);
  values_.push_back(values);
  return static_cast<std::uint32_t>(place_.size() - 1);
}

std::uint32_t LevelSurface::vertex_between(std::uint32_t a, std::uint32_t b, const Level& level) {
  const auto [known, is_new] = between_.try_emplace({a, b}, 0);
  if (!is_new) return known;
  const std::size_t f = level.function;
  const double crossing = (level.value - values_[a][f]) / (values_[b][f] - values_[a][f]);
  const double share = std::clamp(crossing, min_share, 1 - min_share);
  Values values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double way = within(values_[b][i] - values_[a][i], period_[i]);
    values[i] = within(values_[a][i] + share * way, period_[i]);
  }
  values[f] = level.value;
  return known = add_vertex(place_[a] + share * (place_[b] - place_[a]), values);
}

bool LevelSurface::is_crossed(std::uint32_t a, std::uint32_t b, const Level& level) const {
  if (level.where && (values_[a][*level.where] < 0 || values_[b][*level.where] < 0)) return false;
  const double at_a = values_[a][level.function], at_b = values_[b][level.function];
  return (at_a < level.value) != (at_b < level.value) &&
         std::fabs(at_a - at_b) <= 0.5 * (period_[level.function] > 0 ? period_[level.function] : INFINITY);
}

void LevelSurface::split(std::vector<Tetrahedron>& parts, const Level& level) {
  // Edge by edge in the order of their numbers, so that tetrahedra to both sides of a face split it in the same way.
  // Once all of them have a vertex on the level, no part lies on both sides.
  std::vector<EdgeKey> edges;
  for (const Tetrahedron& t : parts) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (is_crossed(t[i], t[j], level)) edges.emplace_back(t[i], t[j]);
      }
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const auto& [a, b] : edges) {
    const std::uint32_t between = vertex_between(a, b, level);
    for (std::size_t i = parts.size(); i-- > 0;) {
      const auto at_a = std::find(parts[i].begin(), parts[i].end(), a);
      const auto at_b = std::find(parts[i].begin(), parts[i].end(), b);
      if (at_a == parts[i].end() || at_b == parts[i].end()) continue;
      Tetrahedron other = parts[i];
      other[static_cast<std::size_t>(at_a - parts[i].begin())] = between;
      *at_b = between;
      parts.push_back(other);
    }
  }
}

void LevelSurface::add(const Tetrahedron& whole, const std::vector<Level>& levels,
                       const std::function<bool(const std::array<Values, 4>&)>& is_inside) {
  std::vector<Tetrahedron> parts{whole};
  for (const Level& level : levels) split(parts, level);

  // Faces of parts inside that are faces of parts outside.
  std::vector<std::array<std::uint32_t, 3>> outside;
  std::vector<Tetrahedron> inside;
  for (const Tetrahedron& t : parts) {
    if (is_inside({values_[t[0]], values_[t[1]], values_[t[2]], values_[t[3]]})) {
      inside.push_back(t);
    } else {
      for (const glm::uvec3& face : outward_faces(t)) outside.push_back(sorted(face));
    }
  }
  std::sort(outside.begin(), outside.end());
  for (const Tetrahedron& t : inside) {
    for (const glm::uvec3& face : outward_faces(t)) {
      if (std::binary_search(outside.begin(), outside.end(), sorted(face))) surface_.push_back(face);
    }
  }
}

ClosedSurface LevelSurface::solid() const {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(place_.size(), unused);
  ClosedSurface solid;
  for (const glm::uvec3& t : surface_) {
    glm::uvec3 corners;
    for (int i = 0; i < 3; ++i) {
      std::uint32_t& n = number[t[i]];
      if (n == unused) {
        n = static_cast<std::uint32_t>(solid.point.size());
        solid.point.push_back(place_[t[i]]);
      }
      corners[i] = n;
    }
    solid.triangle.push_back(corners);
  }
  return solid;
}

}  // namespace pomona
