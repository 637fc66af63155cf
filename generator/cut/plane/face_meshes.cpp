#include "generator/cut/plane/face_meshes.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/cut/plane/cut_lines.h"
#include "generator/cut/plane/face_builder.h"
#include "generator/cut/section/segment_source.h"
#include "generator/cut/section/size_field.h"

namespace pomona {

namespace {

/// For each of `count` points the first of those it shares its place with.
std::vector<std::uint32_t> first_twins(std::size_t count, const std::vector<Twins>& pairs) {
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0u);
  const auto root = [&](std::uint32_t p) {
    while (parent[p] != p) p = parent[p] = parent[parent[p]];
    return p;
  };
  for (const auto& [a, b] : pairs) {
    const std::uint32_t ra = root(a), rb = root(b);
    parent[std::max(ra, rb)] = std::min(ra, rb);
  }
  for (std::uint32_t p = 0; p < count; ++p) parent[p] = root(p);
  return parent;
}

/// Constraints are not halved below this share of the finest size.
constexpr double shortest_share = 0.25;

constexpr int most_rounds = 4;

/// Lines need their sizes only roughly, and there may be many planes.
constexpr int line_grid = 48;

/// The lines in which planes meet, as fine as the finer of their planes wants them.
std::vector<CutLine> laid_out_lines(SplitMesh& mesh, const CutPlanes& planes,
                                    const std::vector<std::vector<Segment>>& segments, const Bounds& bounds,
                                    const SizeLimits& limits, Threads threads) {
  std::vector<CutLine> lines = cut_lines(mesh, planes, segments, bounds);
  if (lines.empty()) return lines;
  std::vector<CutFace> frames;
  for (int k = 0; k < planes.count(); ++k) frames.push_back(frame_of(planes[k].plane));
  std::vector<std::optional<SizeField>> fields(frames.size());
  parallel_for(fields.size(), threads, [&](std::size_t k) {
    std::vector<SizeSource> sources;
    for (const Segment& s : segments[k]) {
      const glm::dvec2 a = to_face(frames[k], mesh.point[s.from]), b = to_face(frames[k], mesh.point[s.to]);
      sources.push_back(source_of(s, mesh, limits.contrast));
      sources.back().a = a;
      sources.back().b = b;
      sources.back().size *= glm::distance(a, b);
    }
    fields[k].emplace(sources, limits, line_grid);
  });
  const auto size = [&](int plane, const glm::dvec3& p) {
    const auto k = static_cast<std::size_t>(plane);
    return fields[k]->at(to_face(frames[k], p));
  };
  for (CutLine& line : lines) subdivide(line, mesh, planes, size);
  return lines;
}

std::vector<std::vector<Segment>> by_sheet(const CutPlanes& planes, const std::vector<std::vector<Segment>>& segments) {
  std::vector<std::vector<Segment>> of_sheet(planes.sheets.size());
  for (int k = 0; k < planes.count(); ++k) {
    const std::vector<Segment>& of_plane = segments[static_cast<std::size_t>(k)];
    std::vector<Segment>& all = of_sheet[static_cast<std::size_t>(planes[k].sheet)];
    all.insert(all.end(), of_plane.begin(), of_plane.end());
  }
  return of_sheet;
}

}  // namespace

FaceMeshes triangulate(SplitMesh& mesh, const CutPlanes& planes, const std::vector<std::vector<Segment>>& segments,
                       const DiffusionSurfaces& surfaces, const Bodies& bodies, const CutOptions& options) {
  const Bounds bounds = bounds_of(surfaces);
  const double size = glm::length(bounds.size());
  const SizeLimits limits{options.coarsest * size, options.finest * size, options.grading, options.contrast};
  std::vector<CutLine> lines = laid_out_lines(mesh, planes, segments, bounds, limits, options.threads);
  const std::vector<std::vector<Segment>> of_sheet = by_sheet(planes, segments);

  std::vector<std::size_t> largest_first(of_sheet.size());
  std::iota(largest_first.begin(), largest_first.end(), std::size_t{0});
  std::stable_sort(largest_first.begin(), largest_first.end(),
                   [&](std::size_t a, std::size_t b) { return of_sheet[a].size() > of_sheet[b].size(); });

  // A crossing on a line is news to the other planes there: then all start again. Once is nearly always enough.
  for (int round = 1;; ++round) {
    FaceMeshes all;
    std::vector<Twins> twins;
    Unshared unshared;
    std::vector<std::optional<FaceBuilder>> builders(planes.sheets.size());
    parallel_for(builders.size(), options.threads, [&](std::size_t i) {
      const std::size_t sheet = largest_first[i];
      if (of_sheet[sheet].empty()) return;
      FaceBuilder& builder = builders[sheet].emplace(mesh, planes, planes.sheets[sheet].first, of_sheet[sheet], lines);
      builder.conform(shortest_share * limits.finest);
      builder.sample(limits, surfaces, bodies);
      builder.conform(shortest_share * limits.finest);
      builder.update();
    });
    for (std::optional<FaceBuilder>& builder : builders) {
      if (builder) all.faces.push_back(builder->finish(mesh, all, twins, unshared));
    }
    if (!unshared.empty() && round < most_rounds) {
      for (CutLine& line : lines) insert(line, unshared[&line], mesh);
      continue;
    }
    std::sort(all.edge_point.begin(), all.edge_point.end());
    all.edge_point.erase(std::unique(all.edge_point.begin(), all.edge_point.end()), all.edge_point.end());
    all.same_as = first_twins(mesh.point.size(), twins);
    return all;
  }
}

}  // namespace pomona
