// The solution between the nodes: from the corners of a point's cell that it sees, and the surfaces that hide the rest.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/diffusion/harmonic/cell_triangles.h"
#include "generator/diffusion/harmonic/lattice.h"
#include "generator/diffusion/harmonic/node_runs.h"
#include "generator/diffusion/harmonic/quad.h"

namespace pomona {

/// What is kept of a solved grid.
struct SolvedGrid {
  Lattice lattice;
  NodeRuns runs;
  RawArray<Quad> value;
};

struct LookedUp {
  glm::vec3 color{0};
  float distance = 0;                 ///< to the nearest surface in the cell, metres; infinite without one
  std::optional<std::uint32_t> side;  ///< the nearest that is seen there: 2 * triangle, + 1 for its back
};

class FieldLookUp {
 public:
  FieldLookUp(const SnappedSurfaces& snapped, SolvedGrid grid, CellTriangles triangles);

  /// Nothing outside the grid, and where neither a node nor a surface is in sight.
  std::optional<LookedUp> at(const glm::vec3& point) const;

  std::size_t bytes() const;

 private:
  struct Spot;
  std::optional<LookedUp> between_nodes(const Spot& spot) const;
  std::optional<LookedUp> beside_surfaces(const Spot& spot, std::span<const std::uint32_t> triangles) const;
  std::array<const Quad*, 8> corners(const Spot& spot) const;

  const DiffusionSurfaces& surfaces_;
  SolvedGrid grid_;
  CellTriangles triangles_;
  std::vector<glm::vec3> position_;  ///< of vertices, in cells
};

}  // namespace pomona
