// Surfaces with their corners on nodes of a lattice, so that every decision is a tie, and the grids around them.
#pragma once

#include <vector>

#include "generator/diffusion/harmonic/cut_arms.h"
#include "generator/diffusion/harmonic/grid_level.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "tests/cut/carve/moved_knife.h"
#include "tests/shapes/shapes.h"

namespace pomona::shapes {

/// Nodes at -2, -1, .., 13 along x and to 6 along y and z; coordinates are metres.
Lattice whole_lattice();

glm::dvec3 place_of(const Lattice& lattice, const Node& node);

/// Every node of a lattice, z slowest.
std::vector<Node> nodes_of(const Lattice& lattice);

DiffusionSurfaces surfaces_of(const std::vector<Corners>& triangles, const Paint& paint = {});

/// Whether a node of a lattice that has moved by (e, e^2, e^3) is behind all triangles of a convex shape.
bool holds(const std::vector<Corners>& convex, const glm::dvec3& place);

std::vector<std::uint32_t> all_triangles(const DiffusionSurfaces& surfaces);

/// All nodes that lie in the lattice: an entry per block, a bit per node.
std::vector<std::uint8_t> all_members(const SparseBlocks& blocks);

/// A lattice and the arms of all its nodes around some surfaces.
struct GriddedShapes {
  GriddedShapes(const DiffusionSurfaces& all, const Lattice& nodes);

  DiffusionSurfaces surfaces;
  Lattice lattice;
  SparseBlocks blocks;
  SnappedSurfaces snapped;
  ArmFinder finder;

  bool is_open(const Node& node, int direction) const;
  CutArms arms() const;
};

Node beside(Node node, int direction);

/// The cut of a stored node's arm; nothing if it is not cut.
const ArmCut* cut_of(const CutArms& arms, std::uint32_t node, int direction);

}  // namespace pomona::shapes
