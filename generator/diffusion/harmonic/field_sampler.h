// Samples the solution at any point: from the corners of the point's cell that it sees, and from the surfaces that hide
// the other corners.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/diffusion/harmonic/cell_triangles.h"
#include "generator/diffusion/harmonic/large_memory.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/quad.h"
#include "generator/diffusion/harmonic/sparse_blocks.h"

namespace pomona {

/// One solved grid.
struct SolvedGrid {
  Lattice lattice;
  SparseBlocks blocks;
  std::vector<std::uint8_t> members;  ///< per block, a bit for each node that has a value
  RawArray<Quad> value;               ///< per stored node
};

/// All solved grids, and the labels that tell the parts apart.
struct SolvedGrids {
  std::vector<SolvedGrid> grids;     ///< the finest patches first, the grid that covers everything last
  SparseBlocks every_other;          ///< the nodes of the last grid with even coordinates
  std::vector<std::uint32_t> label;  ///< labels of these nodes, see nearest_labels()
};

struct FieldSample {
  glm::vec3 color{0};                 ///< linear
  float distance = 0;                 ///< to the nearest surface in the cell, metres; infinite if there is none
  std::optional<std::uint32_t> side;  ///< side of the nearest surface: 2 * triangle, + 1 for its back
};

class FieldSampler {
 public:
  /// \param triangles of each cell of the last grid.
  FieldSampler(const SnappedSurfaces& snapped, SolvedGrids solved, CellTriangles triangles);

  /// The sample at a point. Nothing outside the grid, and where neither a node nor a surface is visible.
  std::optional<FieldSample> at(const glm::vec3& point) const;

  std::size_t bytes() const;

 private:
  struct Spot;
  Spot spot_in(const SolvedGrid& grid, const glm::vec3& point) const;
  std::optional<FieldSample> between_nodes(const Spot& spot) const;
  std::optional<FieldSample> beside_surfaces(const Spot& spot, std::span<const std::uint32_t> triangles) const;
  std::optional<std::uint32_t> label_near(const Node& cell) const;

  const DiffusionSurfaces& surfaces_;
  SolvedGrids solved_;
  CellTriangles triangles_;
  std::vector<glm::vec3> position_;  ///< positions of vertices, in cells of the last grid
};

}  // namespace pomona
