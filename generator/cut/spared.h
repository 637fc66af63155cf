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

/// Surfaces with one of these parts behind them and another before them enclose what is spared, each of their closed
/// shells for itself. It goes to the cell that holds most of it; among cells that hold within a twentieth as much, to
/// the first in the order of cutting. A shell that is open, crosses another spared one or leaves the fruit is cut
/// through. The fruit must have all its surfaces, inner ones too. \param parts ascending.
SparedFruit spared(CutFruit fruit, const DiffusionSurfaces& surfaces, std::span<const int> parts);

}  // namespace pomona
