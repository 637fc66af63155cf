// Depths below the skin of a fruit, for ripeness and browning.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/distance_tree.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The skin is the shell of the boundary with the largest volume. Surfaces without a boundary have no skin.
class SkinDepth {
 public:
  explicit SkinDepth(const DiffusionSurfaces& surfaces);

  /// Distance to the skin, metres; 0 on it, and everywhere if there is none.
  double depth(const glm::dvec3& point) const;

  /// The depths of many points, at most `reach`, metres. Fastest if neighbours in space follow each other.
  std::vector<double> depths(std::span<const glm::dvec3> points, double reach = std::numeric_limits<double>::infinity(),
                             Threads threads = {}) const;

  /// The relative height: 0 at the lowest point of the skin, 1 at its highest; clamped to 0..1. 0 if there is no skin.
  double height(const glm::dvec3& point) const;

  /// The skin itself, facing air.
  const TriangleTree& skin() const { return skin_; }
  bool is_closed() const { return closed_; }

 private:
  TriangleTree skin_;
  DistanceTree distance_;
  bool closed_ = false;
};

}  // namespace pomona
