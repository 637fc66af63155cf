#include "tests/diffusion/harmonic/whole_shapes.h"

#include <algorithm>
#include <numeric>

namespace pomona::shapes {

Lattice whole_lattice() {
  Lattice lattice;
  lattice.origin = glm::dvec3(-2);
  lattice.spacing = 1;
  lattice.count = {16, 9, 9};
  lattice.unit_bits = base_unit_bits;
  return lattice;
}

glm::dvec3 place_of(const Lattice& lattice, const Node& node) {
  return lattice.origin + lattice.spacing * glm::dvec3(node[0], node[1], node[2]);
}

std::vector<Node> nodes_of(const Lattice& lattice) {
  std::vector<Node> nodes;
  for (int z = 0; z < lattice.count[2]; ++z) {
    for (int y = 0; y < lattice.count[1]; ++y) {
      for (int x = 0; x < lattice.count[0]; ++x) nodes.push_back({x, y, z});
    }
  }
  return nodes;
}

DiffusionSurfaces surfaces_of(const std::vector<Corners>& triangles, const Paint& paint) {
  std::vector<glm::vec3> position;
  std::vector<glm::uvec3> numbers;
  for (const Corners& t : triangles) {
    glm::uvec3 number(0);
    for (int i = 0; i < 3; ++i) {
      const glm::vec3 corner(t[static_cast<std::size_t>(i)]);
      const auto known = std::find(position.begin(), position.end(), corner);
      number[i] = static_cast<std::uint32_t>(known - position.begin());
      if (known == position.end()) position.push_back(corner);
    }
    numbers.push_back(number);
  }
  return painted(std::move(position), std::move(numbers), paint);
}

bool holds(const std::vector<Corners>& convex, const glm::dvec3& place) {
  return std::all_of(convex.begin(), convex.end(), [&](const Corners& t) {
    return sign_of_volume(at_rest(t[0]), at_rest(t[1]), at_rest(t[2]), moved(place)) < 0;
  });
}

std::vector<std::uint32_t> all_triangles(const DiffusionSurfaces& surfaces) {
  std::vector<std::uint32_t> all(surfaces.triangle_count());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

std::vector<std::uint8_t> all_members(const SparseBlocks& blocks) {
  std::vector<std::uint8_t> members(blocks.size());
  for (std::size_t r = 0; r < blocks.size(); ++r) members[r] = static_cast<std::uint8_t>((1 << blocks.inside(r)) - 1);
  return members;
}

GriddedShapes::GriddedShapes(const DiffusionSurfaces& all, const Lattice& nodes)
    : surfaces(all),
      lattice(nodes),
      blocks(all_blocks(lattice.count)),
      snapped(pomona::snapped(surfaces, lattice)),
      finder(snapped, all_triangles(surfaces), lattice, blocks, all_members(blocks), Threads{1}) {}

bool GriddedShapes::is_open(const Node& node, int direction) const {
  return finder.open()[static_cast<std::size_t>(blocks.node_at(node[0], node[1], node[2]))] >> direction & 1;
}

CutArms GriddedShapes::arms() const {
  std::vector<std::uint8_t> beyond = all_members(blocks);
  for (std::uint8_t& bits : beyond) bits = static_cast<std::uint8_t>(~bits);
  return finder.arms(blocks, beyond);
}

Node beside(Node node, int direction) {
  node[static_cast<std::size_t>(direction / 2)] += direction % 2 == 1 ? 1 : -1;
  return node;
}

const ArmCut* cut_of(const CutArms& arms, std::uint32_t node, int direction) {
  const auto found =
      std::find_if(arms.node.begin(), arms.node.end(), [&](const CutNode& other) { return other.node == node; });
  if (found == arms.node.end() || (found->cut >> direction & 1) == 0) return nullptr;
  return &arms.cut[found->first_cut + bit_counts[found->cut & ((1u << direction) - 1)]];
}

}  // namespace pomona::shapes
