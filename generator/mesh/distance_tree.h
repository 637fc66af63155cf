// Distances of many points from a mesh: the same results as those of a TriangleTree, but faster.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// A triangle tree with boxes in groups of four, in single precision, rounded outwards. Each box also has a slab
/// perpendicular to its triangles' mean normal: seen from deep inside a round mesh, an oblique box is much nearer than
/// its triangles, but a slab is not. Boxes and slabs only exclude triangles; the others are measured as by
/// TriangleTree::nearest, so that the results are the same.
class DistanceTree {
 public:
  DistanceTree() = default;
  explicit DistanceTree(const TriangleTree& tree);

  bool empty() const { return corners_.empty(); }

  /// The distance of each point, metres, at most `reach`. Fastest if points that follow each other are near each other:
  /// the nearest triangle of one is a good guess for the next.
  std::vector<double> distances(std::span<const glm::dvec3> points,
                                double reach = std::numeric_limits<double>::infinity(), Threads threads = {}) const;

  /// The nearest point of the mesh, if one is nearer than `within`.
  TriangleTree::Nearest nearest(const glm::dvec3& point, double within = std::numeric_limits<double>::infinity()) const;

 private:
  static constexpr std::size_t width = 4;
  static constexpr std::uint32_t is_triangle = 0x80000000u;
  /// Four at once on every x86-64 (GCC and Clang: "vector extensions").
  typedef float Lanes __attribute__((vector_size(4 * sizeof(float))));

  /// Four boxes, coordinate by coordinate. If there are fewer, the rest are empty boxes, to which nothing is near.
  struct Boxes {
    std::array<Lanes, 3> low, high;
    std::array<Lanes, 3> normal;             ///< unit, or 0 if the sum of the normals is 0
    Lanes slab_low, slab_high;               ///< along the normal
    std::array<std::uint32_t, width> child;  ///< index of more boxes; of a triangle, marked

    /// A lower bound of the squared distance of each box's content from the point, up to rounding.
    Lanes squared_distances(const std::array<float, 3>& point) const;
  };

  /// The content of a lane: triangles that follow each other.
  struct Below {
    std::uint32_t first = 0, count = 0;
    std::uint32_t child = 0;
  };

  static Boxes empty_boxes();
  void put(Boxes& boxes, std::size_t lane, const Below& below) const;
  void put_slab(Boxes& boxes, std::size_t lane, std::span<const TriangleTree::Corners> triangles) const;
  Below pack(const TriangleTree& tree, const TriangleTree::Node& node);
  Below pack_leaf(const TriangleTree::Node& leaf);

  std::vector<Boxes> boxes_;  ///< the root's first
  std::vector<TriangleTree::Corners> corners_;
  glm::dvec3 center_{0};  ///< origin of the coordinates in single precision, metres
  double slack_ = 0;      ///< upper bound of the rounding error of a coordinate, metres
};

}  // namespace pomona
