// A closed triangle mesh in a bounding volume hierarchy (BVH), for nearest points, distances and inside tests.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/box.h"

namespace pomona {

/// Two meshes' nearest points; distance 0 where their triangles meet.
struct ClosestPair {
  double distance = std::numeric_limits<double>::infinity();
  glm::dvec3 first{0}, second{0};
};

class TriangleTree {
 public:
  using Corners = std::array<glm::dvec3, 3>;
  struct Node {
    Box<double> box;
    std::uint32_t first = 0;  ///< leaf: first triangle; else: left child, which the right one follows
    std::uint32_t count = 0;  ///< leaf: triangles; else 0
  };
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    glm::dvec3 point{0};
  };

  TriangleTree() = default;
  TriangleTree(std::span<const glm::vec3> position, std::span<const glm::uvec3> triangle);

  /// The same mesh, rotated about the origin.
  TriangleTree rotated(const glm::dquat& rotation) const;

  bool empty() const { return corners_.empty(); }
  const Box<double>& box() const { return nodes_.front().box; }
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Corners>& triangles() const { return corners_; }

  /// True if no earlier triangle has this corner. So a loop over all triangles can visit every vertex once.
  bool owns_corner(std::size_t triangle_index, std::size_t corner) const {
    return (owned_[triangle_index] >> corner & 1) != 0;
  }

  /// True if the box overlaps that of any triangle. If not, the box is completely inside or completely outside the
  /// mesh.
  bool is_near(const Box<double>& box) const;

  /// The nearest point of the surface, if one is nearer than `within`.
  Nearest nearest(const glm::dvec3& point, double within = std::numeric_limits<double>::infinity()) const;

  /// True if the mesh winds around the point: decided by a ray along +X whose crossings are counted so that
  /// a ray through an edge or a vertex crosses exactly one of the triangles there.
  bool contains(const glm::dvec3& point) const;

  /// The height of the first hit of a ray straight down from the point, or -infinity.
  double height_below(const glm::dvec3& point) const;

 private:
  void fit(std::uint32_t node);
  void own_corners();

  std::vector<Node> nodes_;  ///< children after their parents
  std::vector<Corners> corners_;
  std::vector<std::uint8_t> owned_;  ///< per triangle: a bit for each corner
};

/// The nearest points of `a` and of `b` moved by `offset`, if they are nearer than `within`.
ClosestPair closest(const TriangleTree& a, const TriangleTree& b, const glm::dvec3& offset, double within);

}  // namespace pomona
