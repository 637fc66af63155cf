#include "generator/scene/settle/real_contact.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

/// Looks for the deepest point of `a` inside `b`: among the vertices and triangle centres of `a`, part by part of
/// its tree, leaving out parts that are wholly outside.
class DepthSearch {
 public:
  DepthSearch(const PlacedMesh& a, const PlacedMesh& b) : a_(a.mesh), b_(b.mesh), offset_(a.at - b.at) {}

  /// `away` moves `a` out of `b`.
  Overlap run() {
    visit(0, false);
    return deepest_;
  }

 private:
  void visit(std::uint32_t index, bool is_inside) {
    const TriangleTree::Node& node = a_.nodes()[index];
    const Box<double> box = node.box.moved(offset_);
    if (!is_inside) {
      if (squared_distance(box, b_.box()) > 0) return;
      if (!b_.is_near(box)) {
        if (!b_.contains(box.center())) return;
        is_inside = true;
      }
    }
    if (node.count == 0) {
      visit(node.first, is_inside);
      visit(node.first + 1, is_inside);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      const TriangleTree::Corners& t = a_.triangles()[i];
      for (std::size_t k = 0; k < 3; ++k)
        if (a_.owns_corner(i, k)) probe(t[k] + offset_, is_inside);
      probe((t[0] + t[1] + t[2]) / 3.0 + offset_, is_inside);
    }
  }

  void probe(const glm::dvec3& point, bool is_inside) {
    if (b_.nearest(point, deepest_.depth * (1 + 1e-12)).distance <= deepest_.depth) return;
    if (!is_inside && !b_.contains(point)) return;
    const auto nearest = b_.nearest(point);
    if (nearest.distance > deepest_.depth) deepest_ = {nearest.distance, (nearest.point - point) / nearest.distance};
  }

  const TriangleTree &a_, &b_;
  glm::dvec3 offset_;
  Overlap deepest_;
};

}  // namespace

std::optional<Overlap> overlap(const PlacedMesh& a, const PlacedMesh& b) {
  if (squared_distance(a.mesh.box().moved(a.at), b.mesh.box().moved(b.at)) > 0) return std::nullopt;

  // Surfaces apart: only a mesh wholly inside the other could overlap, and then any of its points is inside.
  const double touch = 1e-7 * std::min(a.size, b.size);
  if (closest(a.mesh, b.mesh, b.at - a.at, touch).distance > touch) {
    const bool a_in_b = b.mesh.contains(a.mesh.triangles().front()[0] + a.at - b.at);
    const bool b_in_a = a.mesh.contains(b.mesh.triangles().front()[0] + b.at - a.at);
    if (!a_in_b && !b_in_a) return std::nullopt;
  }

  const Overlap first = DepthSearch(a, b).run();
  const Overlap second = DepthSearch(b, a).run();
  if (first.depth <= 0 && second.depth <= 0) return std::nullopt;
  if (first.depth >= second.depth) return first;
  return Overlap{second.depth, -second.away};
}

double distance(const PlacedMesh& a, const PlacedMesh& b, double within) {
  if (squared_distance(a.mesh.box().moved(a.at), b.mesh.box().moved(b.at)) > within * within)
    return std::numeric_limits<double>::infinity();
  return closest(a.mesh, b.mesh, b.at - a.at, within).distance;
}

}  // namespace pomona
