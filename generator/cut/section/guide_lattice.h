// Guides of texture detail at any place of cut faces: the way to the skin and the layer on the nodes of a lattice.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/cut/section/detail_guide.h"
#include "generator/mesh/box.h"

namespace pomona {

/// The lattice of a fruit, which depends on the fruit alone and on no cut: node n lies at (n + 1/2) spacing, so that
/// usual knives, at 0 on an axis, pass through the middle of cells.
struct LatticeFrame {
  double spacing = 1;  ///< metres
  glm::ivec3 low{0};   ///< the lowest node
  glm::ivec3 count{0};

  glm::dvec3 place_of(const glm::ivec3& node) const { return (glm::dvec3(node) + 0.5) * spacing; }
};

/// The longest side of the box has 64 cells; one more surrounds it.
LatticeFrame lattice_frame(const Box<double>& fruit);

/// The corners of all cells in which the triangles lie, and of those an eighth of the spacing around them: pixels have
/// their middles a little beyond a rim. In the order z, y, x.
std::vector<glm::ivec3> nodes_around(const LatticeFrame& frame, std::span<const std::array<glm::dvec3, 3>> triangles);

/// Guides between nodes, trilinear. The value at a node depends on its place alone, and so does the guide at any place:
/// lattices of one fruit agree to the bit wherever both know it, whatever the knives.
class GuideLattice {
 public:
  /// \param value of each node: the way to the skin, and the layer, metres.
  GuideLattice(const LatticeFrame& frame, std::span<const glm::ivec3> nodes, std::span<const glm::vec4> value);

  /// The way to the skin, and the layer; nothing unless all corners of the place's cell are known.
  std::optional<glm::vec4> at(const glm::dvec3& place) const;

  // What the GPU needs, too: blocks of four nodes a side, x innermost, and the nodes in each alike.
  const LatticeFrame& frame() const { return frame_; }
  const std::vector<std::uint32_t>& blocks() const { return start_; }  ///< where the values of each begin; 0: no node
  const std::vector<glm::vec4>& values() const { return value_; }      ///< not a number where nothing is known

 private:
  static constexpr int block_bits = 2;
  static constexpr int block_side = 1 << block_bits;
  static constexpr std::uint32_t nodes_of_block = block_side * block_side * block_side;

  /// The block of a node counted from the lowest, and the node's number within its block.
  std::size_t block_of(const glm::ivec3& n) const;
  static std::size_t within_block(const glm::ivec3& n);

  LatticeFrame frame_;
  glm::ivec3 blocks_{0};
  std::vector<std::uint32_t> start_;
  std::vector<glm::vec4> value_;  // the first block is that of no node
};

/// The guide at a place of a cut face: the way and the layer of the lattice, if there is one and it knows the place.
/// \param between the guide as interpolated between vertices, which has the shares.
DetailGuide guide_at(const GuideLattice* lattice, const glm::dvec3& place, const DetailGuide& between);

}  // namespace pomona
