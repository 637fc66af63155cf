// How far many places lie from a mesh: the answers of a TriangleTree, asked by the ten thousand.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// A triangle tree packed four boxes side by side, in single precision, rounded outwards. Each box has a slab across
/// its triangles' mean normal, too: seen from deep inside a round mesh, boxes that lie aslant reach nearer than what is
/// in them, slabs do not. Both only say which triangles cannot be the nearest; those that may be are measured as
/// TriangleTree::nearest measures them, so that the answers are the same.
class DistanceTree {
 public:
  DistanceTree() = default;
  explicit DistanceTree(const TriangleTree& tree);

  bool empty() const { return corners_.empty(); }

  /// The distance of each point, metres; `reach` where it is no less. Points that follow each other are best near each
  /// other: what is nearest to one is a good guess for the next.
  std::vector<double> distances(std::span<const glm::dvec3> points,
                                double reach = std::numeric_limits<double>::infinity(), Threads threads = {}) const;

  /// The nearest point of the mesh, if one is nearer than `within`.
  TriangleTree::Nearest nearest(const glm::dvec3& point, double within = std::numeric_limits<double>::infinity()) const;

 private:
  static constexpr std::size_t width = 4;
  static constexpr std::uint32_t is_triangle = 0x80000000u;
  /// Four at once on every x86-64 (GCC and Clang: "vector extensions").
  typedef float Lanes __attribute__((vector_size(4 * sizeof(float))));

  /// Four boxes, coordinate by coordinate; empty ones, which nothing is near, where there are fewer.
  struct Boxes {
    std::array<Lanes, 3> low, high;
    std::array<Lanes, 3> normal;             ///< unit, or 0 where the normals even out
    Lanes slab_low, slab_high;               ///< along the normal
    std::array<std::uint32_t, width> child;  ///< index of more boxes; of a triangle, marked

    /// No more than the squared distance of what is in each from the point, up to rounding.
    Lanes squared_distances(const std::array<float, 3>& point) const;
  };

  /// What a lane stands for: triangles that follow each other, and where they are found.
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
  glm::dvec3 center_{0};  ///< what single precision is about
  double slack_ = 0;      ///< more than what rounding moves a coordinate by, metres
};

}  // namespace pomona
