#include "render/texture/charts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/disjoint_sets.h"
#include "generator/base/error.h"

namespace pomona {

namespace {

glm::dvec3 area_vector(const Solid& solid, std::size_t t) {
  const glm::uvec3& v = solid.triangle[t];
  const glm::dvec3 a(solid.position[v.x]), b(solid.position[v.y]), c(solid.position[v.z]);
  return glm::cross(b - a, c - a);
}

/// 0..5: +x -x +y -y +z -z; ties go to the earlier axis.
int facing(const glm::dvec3& normal) {
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::abs(normal[k]) > std::abs(normal[axis])) axis = k;
  }
  return 2 * axis + (normal[axis] < 0 ? 1 : 0);
}

/// What triangles of one chart have in common: their cut face, or their surface and the axis they face.
struct Kind {
  std::int32_t cut_face, surface;
  int axis;
  auto operator<=>(const Kind&) const = default;
};

Kind kind_of(const Solid& solid, std::size_t t) {
  if (solid.cut_face[t] >= 0) return {solid.cut_face[t], -1, -1};
  return {-1, solid.surface[t], facing(area_vector(solid, t))};
}

/// The projection plane of a chart, seen from outside.
void lay_flat(const Solid& solid, const Kind& kind, Chart& chart) {
  constexpr glm::dvec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (kind.cut_face < 0) {
    const int axis = kind.axis / 2;
    chart.u = axes[(axis + 1) % 3] * (kind.axis % 2 == 0 ? 1.0 : -1.0);
    chart.v = axes[(axis + 2) % 3];
  } else {
    glm::dvec3 normal(0.0);
    for (const std::uint32_t t : chart.triangles) normal += area_vector(solid, t);
    const double size = glm::length(normal);
    normal = size > 0 ? normal / size : axes[2];
    chart.u = glm::normalize(glm::cross(axes[(facing(normal) / 2 + 1) % 3], normal));
    chart.v = glm::cross(normal, chart.u);
  }
  bool first = true;
  for (const std::uint32_t t : chart.triangles) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec2 p = chart.project(solid.position[solid.triangle[t][k]]);
      chart.low = first ? p : glm::min(chart.low, p);
      chart.high = first ? p : glm::max(chart.high, p);
      first = false;
    }
  }
}

glm::ivec2 texels_of(const Chart& chart, double scale, int margin) {
  const glm::dvec2 size = (chart.high - chart.low) * scale;
  return glm::ivec2(glm::ceil(size)) + glm::ivec2(2 * margin + 1);
}

/// Shelf packing at one scale; nothing if it does not fit.
std::optional<std::vector<glm::ivec2>> shelved(const std::vector<Chart>& charts, double scale, int side, int margin) {
  std::vector<glm::ivec2> size;
  for (const Chart& chart : charts) size.push_back(texels_of(chart, scale, margin));
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return size[a].y > size[b].y; });

  std::vector<glm::ivec2> corner(charts.size());
  glm::ivec2 pen(0);
  int shelf = 0;
  for (const std::size_t c : order) {
    if (pen.x + size[c].x > side) pen = {0, pen.y + shelf};
    if (pen.x == 0) shelf = size[c].y;
    if (size[c].x > side || pen.y + size[c].y > side) return std::nullopt;
    corner[c] = pen;
    pen.x += size[c].x;
  }
  return corner;
}

}  // namespace

std::vector<Chart> charts_of(const Solid& solid) {
  // Join triangles of a kind that share a vertex.
  const std::size_t count = solid.triangle.size();
  std::vector<Kind> kind(count);
  for (std::size_t t = 0; t < count; ++t) kind[t] = kind_of(solid, t);
  DisjointSets sets(count);
  std::map<std::pair<std::uint32_t, Kind>, std::uint32_t> first_at;
  for (std::size_t t = 0; t < count; ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [place, added] = first_at.try_emplace({solid.triangle[t][k], kind[t]}, static_cast<std::uint32_t>(t));
      if (!added) sets.join(place->second, static_cast<std::uint32_t>(t));
    }
  }

  // Collect them in the order of their first triangle.
  std::vector<Chart> charts;
  std::map<std::uint32_t, std::size_t> chart_of_root;
  for (std::size_t t = 0; t < count; ++t) {
    const auto [place, added] = chart_of_root.try_emplace(sets.root(static_cast<std::uint32_t>(t)), charts.size());
    if (added) charts.emplace_back().cut_face = kind[t].cut_face;
    charts[place->second].triangles.push_back(static_cast<std::uint32_t>(t));
  }
  for (Chart& chart : charts) lay_flat(solid, kind[chart.triangles.front()], chart);
  return charts;
}

Packing packed(const std::vector<Chart>& charts, int side, int margin) {
  // Halve the interval between a scale that fits and one that cannot.
  double area = 0;
  for (const Chart& chart : charts) area += (chart.high.x - chart.low.x) * (chart.high.y - chart.low.y);
  double fits = 0, too_large = area > 0 ? side / std::sqrt(area) : side;
  auto corner = shelved(charts, fits, side, margin);
  if (!corner) {
    throw Error(ExitStatus::usage, "--texture " + std::to_string(side) + ": too few texels for this piece",
                "its surface falls into " + std::to_string(charts.size()) + " charts; take a larger texture");
  }
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (fits + too_large);
    if (auto at_middle = shelved(charts, middle, side, margin)) {
      corner = std::move(at_middle);
      fits = middle;
    } else {
      too_large = middle;
    }
  }
  return {fits, *corner};
}

}  // namespace pomona
