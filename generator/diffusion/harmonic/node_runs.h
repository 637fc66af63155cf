// Which nodes of a lattice are stored: runs of eight along x, so that what is not needed costs nothing.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "generator/diffusion/harmonic/lattice.h"

namespace pomona {

/// Directions of links: 2 * axis, + 1 towards larger coordinates.
enum Direction : int { x_down, x_up, y_down, y_up, z_down, z_up };

/// Eight nodes from (8 * block, y, z) on.
struct NodeRun {
  std::int32_t block = 0, y = 0, z = 0;
};

/// Sorted by z, then y, then block; run r holds the stored nodes 8 r to 8 r + 7. The last run of a row may reach
/// beyond the lattice.
struct NodeRuns {
  static constexpr int length = 8;
  static constexpr std::int32_t none = -1;

  Node count{};
  int blocks = 0;  ///< along x
  std::vector<NodeRun> run;
  std::vector<std::int32_t> place;            ///< of the run at (z * count.y + y) * blocks + block, or none
  std::vector<std::uint32_t> first_of_plane;  ///< one per z, and the end

  std::size_t node_count() const { return run.size() * length; }

  /// The run over (block, y, z); none outside the lattice too.
  std::int32_t at(int block, int y, int z) const {
    if (block < 0 || y < 0 || z < 0 || block >= blocks || y >= count[1] || z >= count[2]) return none;
    return place[row(y, z) + static_cast<std::size_t>(block)];
  }

  /// The stored node at (x, y, z); none where it is not stored.
  std::int32_t node_at(int x, int y, int z) const {
    if (x < 0 || x >= count[0]) return none;
    const std::int32_t found = at(x / length, y, z);
    return found == none ? none : found * length + x % length;
  }

 private:
  std::size_t row(int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(count[1]) + static_cast<std::size_t>(y)) *
           static_cast<std::size_t>(blocks);
  }
};

/// Those for which `wanted`, one entry per place (0 or not), says so.
NodeRuns make_node_runs(const Node& count, const std::vector<std::uint8_t>& wanted);

/// All of them.
NodeRuns all_node_runs(const Node& count);

/// The runs in `parts` ranges of whole planes with about as many runs each.
std::vector<std::pair<std::size_t, std::size_t>> ranges_of_planes(const NodeRuns& runs, std::size_t parts);

}  // namespace pomona
