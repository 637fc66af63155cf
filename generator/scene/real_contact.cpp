#include "generator/scene/real_contact.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

Box world_box(const PlacedMesh& placed) {
  Box box = placed.mesh.box();
  box.low += placed.at;
  box.high += placed.at;
  return box;
}

bool is_in(const Box& box, const glm::dvec3& p) {
  return p.x >= box.low.x && p.y >= box.low.y && p.z >= box.low.z && p.x <= box.high.x && p.y <= box.high.y &&
         p.z <= box.high.z;
}

/// The deepest probe of `a` inside `b`; `away` moves `a` out of `b`.
Overlap deepest_inside(const PlacedMesh& a, const PlacedMesh& b) {
  Overlap deepest;
  const glm::dvec3 offset = a.at - b.at;
  const Box& reach = b.mesh.box();
  for (const glm::dvec3& probe : a.mesh.probes()) {
    const glm::dvec3 point = probe + offset;
    if (!is_in(reach, point)) continue;
    if (b.mesh.nearest(point, deepest.depth * (1 + 1e-12)).distance <= deepest.depth) continue;
    if (!b.mesh.contains(point)) continue;
    const auto nearest = b.mesh.nearest(point);
    if (nearest.distance <= deepest.depth) continue;
    deepest = {nearest.distance, (nearest.point - point) / nearest.distance};
  }
  return deepest;
}

}  // namespace

std::optional<Overlap> overlap(const PlacedMesh& a, const PlacedMesh& b) {
  if (squared_distance(world_box(a), world_box(b)) > 0) return std::nullopt;

  // Surfaces apart: only a mesh wholly inside the other could overlap, and then any of its points is inside.
  const double touch = 1e-7 * std::min(a.size, b.size);
  if (closest(a.mesh, b.mesh, b.at - a.at, touch).distance > touch) {
    const bool a_in_b = b.mesh.contains(a.mesh.probes().front() + a.at - b.at);
    const bool b_in_a = a.mesh.contains(b.mesh.probes().front() + b.at - a.at);
    if (!a_in_b && !b_in_a) return std::nullopt;
  }

  const Overlap first = deepest_inside(a, b);
  const Overlap second = deepest_inside(b, a);
  if (first.depth <= 0 && second.depth <= 0) return std::nullopt;
  if (first.depth >= second.depth) return first;
  return Overlap{second.depth, -second.away};
}

double distance(const PlacedMesh& a, const PlacedMesh& b, double within) {
  if (squared_distance(world_box(a), world_box(b)) > within * within) return std::numeric_limits<double>::infinity();
  return closest(a.mesh, b.mesh, b.at - a.at, within).distance;
}

std::vector<Fit> measure_fits(std::span<const PlacedMesh> pieces, const PlacedMesh& stand, Threads threads) {
  std::vector<Fit> fits(pieces.size());
  parallel_for(pieces.size(), threads, [&](std::size_t i) {
    const PlacedMesh& piece = pieces[i];
    double gap = 4 * piece.size;
    double depth = 0;
    for (std::size_t j = 0; j <= pieces.size(); ++j) {
      if (j == i) continue;
      const PlacedMesh& other = j < pieces.size() ? pieces[j] : stand;
      gap = std::min(gap, distance(piece, other, gap));
      if (const auto inside = overlap(piece, other)) gap = 0, depth = std::max(depth, inside->depth);
    }
    fits[i] = {gap / piece.size, depth / piece.size};
  });
  return fits;
}

}  // namespace pomona
