#include "render/texture/charts.h"

#include <cmath>
#include <map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/disjoint_sets.h"
#include "render/texture/skin_regions.h"
#include "render/texture/triangle_neighbors.h"

namespace pomona {

namespace {

glm::dvec3 area_vector(const Solid& solid, std::size_t t) {
  const glm::uvec3& v = solid.triangle[t];
  const glm::dvec3 a(solid.position[v.x]), b(solid.position[v.y]), c(solid.position[v.z]);
  return glm::cross(b - a, c - a);
}

/// Triangles with their corners by place, each place once.
Patch3 patch_of(const Solid& solid, const TriangleNeighbors& neighbors, const std::vector<std::uint32_t>& triangles) {
  Patch3 patch;
  std::map<std::uint32_t, std::uint32_t> number_of;
  for (const std::uint32_t t : triangles) {
    glm::uvec3 corners(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t place = neighbors.place_of[solid.triangle[t][k]];
      const auto [entry, is_new] = number_of.try_emplace(place, static_cast<std::uint32_t>(patch.point.size()));
      if (is_new) patch.point.emplace_back(solid.position[place]);
      corners[k] = entry->second;
    }
    patch.triangle.push_back(corners);
  }
  return patch;
}

/// Directions of a plane as its picture shows it, seen against the normal: upright where it stands, -Z upwards where
/// it lies level and is seen from above, as section pictures have it.
void look_at(Chart& chart, const glm::dvec3& normal) {
  const glm::dvec3 above = std::abs(normal.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
  chart.right = glm::normalize(glm::cross(above, normal));
  chart.up = glm::cross(normal, chart.right);
}

glm::dvec2 projected(const Chart& chart, const glm::dvec3& p) {
  return {glm::dot(p, chart.right), glm::dot(p, chart.up)};
}

/// Puts places with y up into the chart: y down, from 0.
void set_flat(Chart& chart, const std::vector<glm::dvec2>& y_up) {
  glm::dvec2 low = y_up.front(), high = low;
  for (const glm::dvec2& p : y_up) low = glm::min(low, p), high = glm::max(high, p);
  chart.origin = {low.x, high.y};
  chart.size = high - low;
  for (const glm::dvec2& p : y_up) chart.flat.emplace_back(p.x - low.x, high.y - p.y);
}

std::vector<glm::dvec2> projected(const Chart& chart, const Patch3& patch) {
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : patch.point) flat.push_back(projected(chart, p));
  return flat;
}

/// The parts of the cut faces, each connected across edges.
std::vector<Chart> cut_face_charts(const Solid& solid, const TriangleNeighbors& neighbors) {
  const std::size_t count = solid.triangle.size();
  DisjointSets sets(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    for (const std::int32_t next : neighbors.neighbor[t]) {
      if (next >= 0) sets.join(t, static_cast<std::uint32_t>(next));
    }
  }
  std::map<std::uint32_t, std::size_t> chart_of;
  std::vector<Chart> charts;
  for (std::uint32_t t = 0; t < count; ++t) {
    if (solid.cut_face[t] < 0) continue;
    const auto [entry, is_new] = chart_of.try_emplace(sets.root(t), charts.size());
    if (is_new) charts.emplace_back().cut_face = solid.cut_face[t];
    charts[entry->second].triangles.push_back(t);
  }
  return charts;
}

void lay_face_flat(const Solid& solid, const TriangleNeighbors& neighbors, Chart& chart) {
  glm::dvec3 normal(0);
  for (const std::uint32_t t : chart.triangles) normal += area_vector(solid, t);
  const double length = std::sqrt(glm::dot(normal, normal));
  look_at(chart, length > 0 ? normal / length : glm::dvec3(0, 0, 1));
  const Patch3 patch = patch_of(solid, neighbors, chart.triangles);
  chart.corners = patch.triangle;
  set_flat(chart, projected(chart, patch));
}

/// One region of skin as one chart; where its projection covers itself, as several.
std::vector<Chart> skin_charts(const Solid& solid, const TriangleNeighbors& neighbors, const SkinRegion& region) {
  std::vector<Chart> charts;
  std::vector<std::uint32_t> left = region.triangles;
  while (!left.empty()) {
    Chart chart;
    look_at(chart, region.normal);
    const Patch3 whole = patch_of(solid, neighbors, left);
    const std::vector<std::uint32_t> covering = overlapping(whole.triangle, projected(chart, whole));
    std::vector<std::uint32_t> later;
    for (std::size_t i = 0, next = 0; i < left.size(); ++i) {
      const bool covers = next < covering.size() && covering[next] == i;
      (covers ? later : chart.triangles).push_back(left[i]);
      next += covers ? 1 : 0;
    }
    const Patch3 patch = covering.empty() ? whole : patch_of(solid, neighbors, chart.triangles);
    chart.corners = patch.triangle;
    const std::vector<glm::dvec2> start = projected(chart, patch);
    std::vector<glm::dvec2> flat = relaxed(patch, start);
    if (!overlapping(patch.triangle, flat).empty()) flat = start;
    set_flat(chart, flat);
    chart.stretch = stretch_of(patch, flat);
    charts.push_back(std::move(chart));
    left = std::move(later);
  }
  return charts;
}

}  // namespace

std::vector<Chart> charts_of(const Solid& solid, Threads threads) {
  const TriangleNeighbors neighbors = triangle_neighbors(solid);
  std::vector<Chart> charts = cut_face_charts(solid, neighbors);
  for (Chart& chart : charts) lay_face_flat(solid, neighbors, chart);

  const std::vector<SkinRegion> regions = skin_regions(solid, neighbors);
  std::vector<std::vector<Chart>> skins(regions.size());
  parallel_for(regions.size(), threads, [&](std::size_t r) { skins[r] = skin_charts(solid, neighbors, regions[r]); });
  for (std::vector<Chart>& of_region : skins) {
    for (Chart& chart : of_region) charts.push_back(std::move(chart));
  }
  return charts;
}

}  // namespace pomona
