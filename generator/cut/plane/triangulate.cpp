#include "generator/cut/plane/triangulate.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/cut/plane/blade_face.h"
#include "generator/cut/plane/cut_lines.h"
#include "generator/cut/section/face_frame.h"
#include "generator/cut/section/segment_source.h"
#include "generator/cut/section/size_field.h"
#include "generator/mesh/disjoint_sets.h"

namespace pomona {

namespace {

using SegmentLists = std::vector<std::vector<CutSegment>>;
using Builders = std::vector<std::optional<BladeFaceBuilder>>;

/// Constraints are not halved below this share of the finest size.
constexpr double shortest_share = 0.25;

constexpr int max_rounds = 4;

/// Cells of the grid of sizes for lines, which need them only roughly; there may be many planes.
constexpr int line_grid = 48;

/// The lines in which planes meet, as fine as the finer of their planes needs them.
CutLines laid_out_lines(SplitMesh mesh, const CutPlanes& planes, const SegmentLists& segments,
                        const Box<double>& bounds, const SizeLimits& limits, Threads threads) {
  CutLines all = cut_lines(std::move(mesh), planes, segments, bounds);
  if (all.lines.empty()) return all;
  std::vector<CutFace> frames;
  for (int k = 0; k < planes.count(); ++k) frames.push_back(frame_of(planes[k].plane));
  std::vector<std::optional<SizeField>> fields(frames.size());
  parallel_for(fields.size(), threads, [&](std::size_t k) {
    std::vector<SizeSource> sources;
    for (const CutSegment& s : segments[k]) {
      const glm::dvec2 a = to_face(frames[k], all.mesh.point[s.from]), b = to_face(frames[k], all.mesh.point[s.to]);
      sources.push_back(source_of(s, all.mesh, limits.contrast));
      sources.back().a = a;
      sources.back().b = b;
      sources.back().size *= glm::distance(a, b);
    }
    fields[k].emplace(sources, limits, line_grid);
  });
  return subdivided(std::move(all), planes, [&](int plane, const glm::dvec3& p) {
    const auto k = static_cast<std::size_t>(plane);
    return fields[k]->at(to_face(frames[k], p));
  });
}

SegmentLists by_blade(const CutPlanes& planes, const SegmentLists& segments) {
  SegmentLists of_blade(planes.blades.size());
  for (int k = 0; k < planes.count(); ++k) {
    const std::vector<CutSegment>& of_plane = segments[static_cast<std::size_t>(k)];
    std::vector<CutSegment>& all = of_blade[static_cast<std::size_t>(planes[k].blade)];
    all.insert(all.end(), of_plane.begin(), of_plane.end());
  }
  return of_blade;
}

/// The blades' numbers, those with most segments first, so that threads are busy to the end.
std::vector<std::size_t> largest_first(const SegmentLists& of_blade) {
  std::vector<std::size_t> order(of_blade.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return of_blade[a].size() > of_blade[b].size(); });
  return order;
}

/// For each of `count` points the first of those it shares its place with.
std::vector<std::uint32_t> first_twins(std::size_t count, const std::vector<Twins>& pairs) {
  DisjointSets places(count);
  for (const auto& [a, b] : pairs) places.join(a, b);
  std::vector<std::uint32_t> first(count);
  for (std::uint32_t p = 0; p < count; ++p) first[p] = places.root(p);
  return first;
}

/// All that the blades add in one round.
struct Round {
  std::vector<BladeFace::NewPoint> point;
  std::vector<Face> faces;
  std::vector<EdgePoint> edge_point;
  std::vector<Twins> twins;
  Unshared unshared;
};

/// Gathers blade after blade, so that the numbers of new points, which begin at `points`, do not depend on threads.
Round finished(Builders builders, std::size_t points) {
  Round round;
  for (std::optional<BladeFaceBuilder>& builder : builders) {
    if (!builder) continue;
    BladeFace made = std::move(*builder).finish(static_cast<std::uint32_t>(points + round.point.size()));
    round.point.insert(round.point.end(), made.point.begin(), made.point.end());
    round.faces.push_back(std::move(made.face));
    round.edge_point.insert(round.edge_point.end(), made.edge_point.begin(), made.edge_point.end());
    round.twins.insert(round.twins.end(), made.twins.begin(), made.twins.end());
    for (const auto& [line, of_line] : made.unshared) {
      std::vector<std::uint32_t>& all = round.unshared[line];
      all.insert(all.end(), of_line.begin(), of_line.end());
    }
  }
  return round;
}

}  // namespace

PlaneFaces triangulate(SplitMesh mesh, const CutPlanes& planes, const std::vector<std::vector<CutSegment>>& segments,
                       const DiffusionSurfaces& surfaces, const Bodies& bodies, const CutOptions& options) {
  const Box<double> bounds = bounds_of(surfaces);
  const double size = glm::length(bounds.size());
  const SizeLimits limits{options.coarsest * size, options.finest * size, options.grading, options.contrast};
  CutLines lines = laid_out_lines(std::move(mesh), planes, segments, bounds, limits, options.threads);
  const SegmentLists of_blade = by_blade(planes, segments);
  const std::vector<std::size_t> order = largest_first(of_blade);

  // If a blade has found a new crossing on a line, the other planes do not know it: all start again. Once is nearly
  // always enough.
  for (int number = 1;; ++number) {
    Builders builders(of_blade.size());
    parallel_for(builders.size(), options.threads, [&](std::size_t i) {
      const std::size_t blade = order[i];
      if (of_blade[blade].empty()) return;
      const int plane = planes.blades[blade].first;
      BladeFaceBuilder& builder = builders[blade].emplace(lines.mesh, planes, plane, of_blade[blade], lines.lines);
      builder.conform(shortest_share * limits.finest);
      builder.sample(limits, surfaces, bodies);
      builder.conform(shortest_share * limits.finest);
      builder.update();
    });
    Round round = finished(std::move(builders), lines.mesh.point.size());
    for (const BladeFace::NewPoint& p : round.point) lines.mesh.add_point(p.place, lines.mesh.sets.with(0, p.plane));
    if (!round.unshared.empty() && number < max_rounds) {
      lines = with_points(std::move(lines), round.unshared);
      continue;
    }
    std::sort(round.edge_point.begin(), round.edge_point.end());
    round.edge_point.erase(std::unique(round.edge_point.begin(), round.edge_point.end()), round.edge_point.end());
    lines.mesh.same_as = first_twins(lines.mesh.point.size(), round.twins);
    return {std::move(lines.mesh), std::move(round.faces), std::move(round.edge_point)};
  }
}

}  // namespace pomona
