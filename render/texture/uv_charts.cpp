#include "render/texture/uv_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/knife/crease.h"
#include "generator/mesh/box.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/weld.h"
#include "render/texture/curved_regions.h"
#include "render/texture/triangle_neighbors.h"

namespace pomona {

namespace {

/// Triangles with their corners by place, each place once.
Patch3 patch_of(const Solid& solid, const TriangleNeighbors& neighbors, const std::vector<std::uint32_t>& triangles) {
  Patch3 patch;
  std::map<std::uint32_t, std::uint32_t> number_of;
  for (const std::uint32_t t : triangles) {
    glm::uvec3 corners(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t place = neighbors.place_of[solid.mesh.triangle[t][k]];
      const auto [entry, is_new] = number_of.try_emplace(place, static_cast<std::uint32_t>(patch.point.size()));
      if (is_new) patch.point.emplace_back(solid.mesh.position[place]);
      corners[k] = entry->second;
    }
    patch.triangle.push_back(corners);
  }
  return patch;
}

/// The directions of a plane in its picture, seen against the normal: +Y upwards, or -Z for a level plane seen from
/// above, as in pictures of sections.
struct ChartView {
  glm::dvec3 right, up;

  explicit ChartView(const glm::dvec3& normal) {
    const glm::dvec3 above = std::abs(normal.y) < 0.999 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    right = glm::normalize(glm::cross(above, normal));
    up = glm::cross(normal, right);
  }

  std::vector<glm::dvec2> of(const Patch3& patch) const {
    std::vector<glm::dvec2> flat;
    for (const glm::dvec3& p : patch.point) flat.emplace_back(glm::dot(p, right), glm::dot(p, up));
    return flat;
  }
};

/// Puts places with y up into the chart, with y down, from 0. Returns the place of (0, 0).
glm::dvec2 set_flat(Chart& chart, const std::vector<glm::dvec2>& y_up) {
  glm::dvec2 low = y_up.front(), high = low;
  for (const glm::dvec2& p : y_up) low = glm::min(low, p), high = glm::max(high, p);
  chart.size = high - low;
  for (const glm::dvec2& p : y_up) chart.flat.emplace_back(p.x - low.x, high.y - p.y);
  return {low.x, high.y};
}

/// The parts of the cut faces, each connected across edges.
std::vector<Chart> cut_face_charts(const Solid& solid, const TriangleNeighbors& neighbors) {
  const std::size_t count = solid.mesh.triangle.size();
  DisjointSets sets(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    for (const std::int32_t next : neighbors.neighbor[t]) {
      if (next >= 0) sets.join(t, static_cast<std::uint32_t>(next));
    }
  }
  std::map<std::uint32_t, std::size_t> chart_of;
  std::vector<Chart> charts;
  for (std::uint32_t t = 0; t < count; ++t) {
    if (solid.mesh.cut_face[t] < 0) continue;
    const auto [entry, is_new] = chart_of.try_emplace(sets.root(t), charts.size());
    if (is_new) charts.emplace_back().cut_face = solid.mesh.cut_face[t];
    charts[entry->second].triangles.push_back(t);
  }
  return charts;
}

glm::dvec3 mean_normal(const Solid& solid, const std::vector<std::uint32_t>& triangles) {
  glm::dvec3 normal(0);
  for (const std::uint32_t t : triangles) normal += solid.mesh.area_vector(t);
  const double length = std::sqrt(glm::dot(normal, normal));
  return length > 0 ? normal / length : glm::dvec3(0, 0, 1);
}

/// A cut face is flat if its points are nearer to its mean plane than this share of its size.
constexpr double flatness = 1e-4;

bool is_flat(const Solid& solid, const std::vector<std::uint32_t>& triangles) {
  const glm::dvec3 normal = mean_normal(solid, triangles);
  Box<double> box;
  double lowest = glm::dot(glm::dvec3(solid.mesh.position[solid.mesh.triangle[triangles.front()].x]), normal),
         highest = lowest;
  for (const std::uint32_t t : triangles) {
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 p(solid.mesh.position[solid.mesh.triangle[t][k]]);
      box.add(p);
      lowest = std::min(lowest, glm::dot(p, normal)), highest = std::max(highest, glm::dot(p, normal));
    }
  }
  return highest - lowest <= flatness * glm::length(box.size());
}

void lay_face_flat(const Solid& solid, const TriangleNeighbors& neighbors, Chart& chart) {
  const Patch3 patch = patch_of(solid, neighbors, chart.triangles);
  chart.corners = patch.triangle;
  const ChartView view(mean_normal(solid, chart.triangles));
  chart.frame = {view.right, view.up, set_flat(chart, view.of(patch))};
}

/// Makes one chart of a region, or several if its projection overlaps itself.
std::vector<Chart> region_charts(const Solid& solid, const TriangleNeighbors& neighbors, const CurvedRegion& region) {
  // Triangles that overlap others, seen along the normal, wait for a later chart.
  std::vector<Chart> charts;
  std::vector<std::uint32_t> left = region.triangles;
  const ChartView view(region.normal);
  while (!left.empty()) {
    Chart chart;
    chart.cut_face = solid.mesh.cut_face[left.front()];
    const Patch3 whole = patch_of(solid, neighbors, left);
    const std::vector<std::uint32_t> covering = overlapping(whole.triangle, view.of(whole));
    std::vector<std::uint32_t> later;
    for (std::size_t i = 0, next = 0; i < left.size(); ++i) {
      const bool covers = next < covering.size() && covering[next] == i;
      (covers ? later : chart.triangles).push_back(left[i]);
      next += covers ? 1 : 0;
    }

    // Flattens with little stretch; if the chart then overlaps itself, keeps the projection.
    const Patch3 patch = covering.empty() ? whole : patch_of(solid, neighbors, chart.triangles);
    chart.corners = patch.triangle;
    const std::vector<glm::dvec2> start = view.of(patch);
    std::vector<glm::dvec2> flat = relaxed(patch, start);
    if (!overlapping(patch.triangle, flat).empty()) flat = start;
    set_flat(chart, flat);
    chart.stretch = stretch_of(patch, flat);
    charts.push_back(std::move(chart));
    left = std::move(later);
  }
  return charts;
}

/// Finds the edges where cut faces go on smoothly beyond their charts.
class SeamFinder {
 public:
  SeamFinder(const Solid& solid, const TriangleNeighbors& neighbors)
      : mesh_(solid.mesh), neighbors_(neighbors), ends_smoothly_(solid.mesh.triangle.size(), {false, false, false}) {
    const std::vector<glm::uvec3> triangles = welded_triangles(neighbors.place_of, solid.mesh.triangle);
    for_each_edge(sorted_half_edges(triangles, {.of_collapsed = true}), [&](std::span<const HalfEdge> edge) {
      for (const HalfEdge& h : edge) {
        ends_smoothly_[h.triangle][h.side] =
            std::any_of(edge.begin(), edge.end(), [&](const HalfEdge& other) { return goes_on(h, other); });
      }
    });
  }

  std::vector<glm::uvec2> seams_of(const Chart& chart) const {
    std::vector<glm::uvec2> seams;
    const std::set<std::uint32_t> own(chart.triangles.begin(), chart.triangles.end());
    for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
      const std::uint32_t t = chart.triangles[i];
      for (int k = 0; k < 3; ++k) {
        const std::int32_t neighbor = neighbors_.neighbor[t][k];
        const bool is_seam = neighbor >= 0 ? !own.contains(static_cast<std::uint32_t>(neighbor)) : ends_smoothly_[t][k];
        if (is_seam) seams.emplace_back(chart.corners[i][k], chart.corners[i][(k + 1) % 3]);
      }
    }
    return seams;
  }

 private:
  /// Searches another face of the same knife. Neighbours run along their edge in opposite directions.
  bool goes_on(const HalfEdge& h, const HalfEdge& other) const {
    const std::int32_t face = mesh_.cut_face[h.triangle], other_face = mesh_.cut_face[other.triangle];
    if (face < 0 || other_face < 0 || face == other_face || h.forward == other.forward) return false;
    const glm::uvec2 v = ends_in(mesh_.triangle, h), w = ends_in(mesh_.triangle, other);
    const auto agree = [&](std::uint32_t p, std::uint32_t q) {
      return static_cast<double>(glm::dot(mesh_.normal[p], mesh_.normal[q])) > smooth_cosine;
    };
    return agree(v.x, w.x) && agree(v.y, w.y);
  }

  const SolidMesh& mesh_;
  const TriangleNeighbors& neighbors_;
  std::vector<std::array<bool, 3>> ends_smoothly_;  // per triangle, at its edge i to i + 1
};

}  // namespace

std::vector<Chart> charts_of(const Solid& solid, Threads threads) {
  // Flat cut faces keep their shape.
  const TriangleNeighbors neighbors = triangle_neighbors(solid);
  std::vector<Chart> charts;
  std::vector<std::uint8_t> is_curved(solid.mesh.triangle.size(), 1);
  for (Chart& chart : cut_face_charts(solid, neighbors)) {
    if (!is_flat(solid, chart.triangles)) continue;
    for (const std::uint32_t t : chart.triangles) is_curved[t] = 0;
    lay_face_flat(solid, neighbors, chart);
    charts.push_back(std::move(chart));
  }

  // All else is curved: makes regions, and charts in the regions' order.
  const std::vector<CurvedRegion> regions = curved_regions(solid, neighbors, is_curved);
  std::vector<std::vector<Chart>> of_region(regions.size());
  parallel_for(regions.size(), threads,
               [&](std::size_t r) { of_region[r] = region_charts(solid, neighbors, regions[r]); });
  for (std::vector<Chart>& of_one : of_region) {
    for (Chart& chart : of_one) charts.push_back(std::move(chart));
  }

  // Marks where a cut goes on smoothly beyond its chart.
  const SeamFinder seams(solid, neighbors);
  for (Chart& chart : charts) {
    if (chart.cut_face >= 0) chart.seams = seams.seams_of(chart);
  }
  return charts;
}

}  // namespace pomona
