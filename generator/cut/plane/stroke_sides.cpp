#include "generator/cut/plane/stroke_sides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "generator/mesh/edge_map.h"

namespace pomona {

namespace {

/// The corner after corner i.
constexpr std::array<std::size_t, 3> next{1, 2, 0};

}  // namespace

StrokeSides::StrokeSides(const SplitMesh& mesh, const CutPlanes& planes, const CutPlanes::Blade& stroke,
                         const DiffusionSurfaces& surfaces)
    : mesh_(mesh), planes_(planes), blade_(stroke), surfaces_(surfaces) {
  for (const glm::dvec3& p : mesh.point) near_.push_back(blade_.stroke->nearest(glm::dvec2(p)));
}

std::vector<int> StrokeSides::of_triangles(const std::function<bool(std::size_t)>& is_positive) const {
  // Each triangle's farthest point tells its side.
  std::vector<int> side;
  for (const Triangle& t : mesh_.triangle) {
    const double farthest = farthest_from(t);
    side.push_back(std::fabs(farthest) <= planes_.tolerance ? 0 : farthest > 0 ? 1 : -1);
  }

  // The first of connected triangles that all lie on the stroke decides for the others, or the chain of their edges
  // would stay open where their sides differ.
  const TrianglesByEdge across = triangles_across(side);
  spread(across, side);
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (side[t] != 0) continue;
    side[t] = is_positive(t) ? 1 : -1;
    spread(across, side);
  }
  return side;
}

/// Triangles on the stroke that cut off a corner of it take their neighbours' side, until nothing changes.
void StrokeSides::spread(const TrianglesByEdge& across, std::vector<int>& side) const {
  for (bool changed = !across.empty(); changed;) {
    changed = false;
    for (const std::vector<std::size_t>& triangles : across) changed = take_side(triangles, side) || changed;
  }
}

/// The triangles at each edge that follows no facet and belongs to a triangle without a side, edge after edge.
StrokeSides::TrianglesByEdge StrokeSides::triangles_across(const std::vector<int>& side) const {
  EdgeMap<std::vector<std::size_t>> across;
  const auto for_each_edge = [&](std::size_t t, const auto& visit) {
    const std::array<std::uint32_t, 3>& v = mesh_.triangle[t].vertex;
    for (std::size_t i = 0; i < 3; ++i) visit(mesh_.point_of[v[i]], mesh_.point_of[v[next[i]]]);
  };
  for (std::size_t t = 0; t < side.size(); ++t) {
    if (side[t] != 0) continue;
    for_each_edge(t, [&](std::uint32_t p, std::uint32_t q) {
      if (facet_with(p, q) < 0) across[{p, q}];
    });
  }
  if (across.empty()) return {};
  for (std::size_t t = 0; t < side.size(); ++t) {
    for_each_edge(t, [&](std::uint32_t p, std::uint32_t q) {
      if (across.contains({p, q})) across[{p, q}].push_back(t);
    });
  }
  TrianglesByEdge all;
  for (const EdgeKey& edge : across.edges()) all.push_back(std::move(across.at(edge)));
  return all;
}

/// Gives triangles at one edge without a side the side of another triangle of their surface there.
bool StrokeSides::take_side(const std::vector<std::size_t>& triangles, std::vector<int>& side) const {
  bool changed = false;
  for (const std::size_t t : triangles) {
    for (const std::size_t other : triangles) {
      const bool same_surface =
          surfaces_.surface[mesh_.triangle[t].source] == surfaces_.surface[mesh_.triangle[other].source];
      if (side[t] != 0 || side[other] == 0 || !same_surface) continue;
      side[t] = side[other];
      changed = true;
    }
  }
  return changed;
}

/// The largest distance from the stroke of a triangle that it does not cross. A triangle with all corners on the stroke
/// spans a bend of it: then its middle and those of its edges count.
double StrokeSides::farthest_from(const Triangle& t) const {
  double farthest = 0;
  const auto see = [&](double distance) {
    if (std::fabs(distance) > std::fabs(farthest)) farthest = distance;
  };
  for (const std::uint32_t v : t.vertex) see(near_[mesh_.point_of[v]].distance);
  if (std::fabs(farthest) > planes_.tolerance) return farthest;
  const glm::dvec2 a(mesh_.place_of(t.vertex[0])), b(mesh_.place_of(t.vertex[1])), c(mesh_.place_of(t.vertex[2]));
  for (const glm::dvec2& p : {(a + b + c) / 3.0, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)}) {
    see(blade_.stroke->nearest(p).distance);
  }
  return farthest;
}

int StrokeSides::facet_with(std::uint32_t p, std::uint32_t q) const {
  if (std::fabs(near_[p].distance) > planes_.tolerance || std::fabs(near_[q].distance) > planes_.tolerance) return -1;
  const int from = std::max(0, near_[p].facet - 1), to = std::min(blade_.count - 1, near_[p].facet + 1);
  for (int plane = blade_.first + from; plane <= blade_.first + to; ++plane) {
    if (is_on_facet(plane, p) && is_on_facet(plane, q)) return plane;
  }
  return -1;
}

bool StrokeSides::is_on_facet(int plane, std::uint32_t point) const {
  const glm::dvec3& place = mesh_.point[point];
  return std::fabs(signed_distance(planes_[plane].plane, place)) <= planes_.tolerance &&
         planes_.is_in_facet(plane, place);
}

}  // namespace pomona
