// Parts that knives spare: an avocado's stone stays whole in one half and leaves its socket in the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A triangle of a spared part's surface that now faces air: the part's own outside, or the wall of its socket.
struct SparedWall {
  SurfaceTriangle triangle;      ///< faces air; its vertices' normals do too. In the cell of the piece that it bounds
  SideOf shows = SideOf::front;  ///< whose colour and part it has: a socket shows the front, what stands out the back
};

/// A cut fruit, and what of it is not cut after all.
struct SparedFruit {
  CutFruit fruit;                     ///< with vertices for the walls; its section still goes through
  std::vector<SparedWall> walls;      ///< of all parts that are spared
  std::vector<std::uint8_t> uncut;    ///< per triangle of the section: within a spared part, so that no piece has it
  std::vector<std::string> warnings;  ///< parts that cannot be spared
};

/// Of the largest share of a shell's volume: cells that hold as much count as equal.
constexpr double nearly_as_much = 0.95;

/// Per triangle of the surfaces, the closed shell around one of these parts that it is of, numbered from 1 in the order
/// of their first triangles; 0 of none. Whether a shell crosses another or leaves the fruit is not asked.
/// \param parts ascending.
std::vector<std::uint32_t> closed_shells(const DiffusionSurfaces& surfaces, std::span<const int> parts);

/// Surfaces with one of these parts behind them and another before them enclose what is spared, each of their closed
/// shells for itself. It goes to the cell that holds most of it; among cells that hold nearly_as_much, to
/// the first in the order of cutting. A shell that is open, crosses another spared one or leaves the fruit is cut
/// through. The fruit must have all its surfaces, inner ones too. \param parts ascending.
SparedFruit spared(CutFruit fruit, const DiffusionSurfaces& surfaces, std::span<const int> parts);

}  // namespace pomona
