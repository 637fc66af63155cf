// The side of a stroke on which each triangle of a split mesh lies, once no triangle crosses the stroke.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Decides by the distance from the stroke, with a tolerance. While this is in use, planes may be added to the mesh,
/// but neither points nor triangles.
class StrokeSides {
 public:
  StrokeSides(const SplitMesh& mesh, const CutPlanes& planes, const CutPlanes::Blade& stroke,
              const DiffusionSurfaces& surfaces);

  /// Per triangle: 1 or -1. If all corners of a triangle lie on the stroke within the tolerance, but one of its edges
  /// lies along no facet, then it cuts off a corner of the stroke; it gets the side of its neighbour across that edge.
  /// \param is_positive decides for a triangle that lies on the stroke and has no such neighbour.
  std::vector<int> of_triangles(const std::function<bool(std::size_t triangle)>& is_positive) const;

  /// The first facet that both points lie on, as a plane; or -1.
  int facet_with(std::uint32_t p, std::uint32_t q) const;

  /// The nearest facet, as a plane.
  int facet_nearest_to(std::uint32_t point) const { return blade_.first + near_[point].facet; }

 private:
  using Triangle = SplitMesh::Triangle;
  using TrianglesByEdge = std::vector<std::vector<std::size_t>>;

  TrianglesByEdge triangles_across(const std::vector<int>& side) const;
  void spread(const TrianglesByEdge& across, std::vector<int>& side) const;
  bool take_side(const std::vector<std::size_t>& triangles, std::vector<int>& side) const;
  double farthest_from(const Triangle& t) const;
  bool is_on_facet(int plane, std::uint32_t point) const;

  const SplitMesh& mesh_;
  const CutPlanes& planes_;
  const CutPlanes::Blade& blade_;
  const DiffusionSurfaces& surfaces_;
  std::vector<Stroke::Place> near_;  // per point
};

}  // namespace pomona
