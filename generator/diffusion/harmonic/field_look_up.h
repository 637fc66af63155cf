// The solution between the nodes: from the corners of a point's cell that it sees, and the surfaces that hide the rest.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/diffusion/harmonic/cell_triangles.h"
#include "generator/diffusion/harmonic/large_memory.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"
#include "generator/diffusion/harmonic/quad.h"

namespace pomona {

/// What is kept of a solved level.
struct SolvedGrid {
  Lattice lattice;
  NodeRuns runs;
  std::vector<std::uint8_t> members;  ///< per run, a bit per node that has a value
  RawArray<Quad> value;
};

/// What is kept of all: a grid, patches of finer ones, and what tells parts.
struct SolvedGrids {
  std::vector<SolvedGrid> grids;     ///< the finest patches first, the grid that holds all last
  NodeRuns every_other;              ///< nodes of that grid with even coordinates
  std::vector<std::uint32_t> label;  ///< of each, see nearest_labels()
};

struct LookedUp {
  glm::vec3 color{0};
  float distance = 0;                 ///< to the nearest surface in the cell, metres; infinite without one
  std::optional<std::uint32_t> side;  ///< the nearest: 2 * triangle, + 1 for its back
};

class FieldLookUp {
 public:
  /// `triangles` in the cells of the last grid.
  FieldLookUp(const SnappedSurfaces& snapped, SolvedGrids solved, CellTriangles triangles);

  /// Nothing outside the grid, and where neither a node nor a surface is in sight.
  std::optional<LookedUp> at(const glm::vec3& point) const;

  std::size_t bytes() const;

 private:
  struct Spot;
  Spot spot_in(const SolvedGrid& grid, const glm::vec3& point) const;
  std::optional<LookedUp> between_nodes(const Spot& spot) const;
  std::optional<LookedUp> beside_surfaces(const Spot& spot, std::span<const std::uint32_t> triangles) const;
  std::optional<std::uint32_t> label_near(const Node& cell) const;

  const DiffusionSurfaces& surfaces_;
  SolvedGrids solved_;
  CellTriangles triangles_;
  std::vector<glm::vec3> position_;  ///< of vertices, in cells of the last grid
};

}  // namespace pomona
