// Spared parts, which knives go around: an avocado's stone stays whole in one half and leaves its socket in the other.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "generator/cut/section/cut_fruit.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A triangle of a spared part's surface that now faces air: the outside of the part, or the wall of its socket.
struct SparedWall {
  SurfaceTriangle triangle;      ///< it and its normals face air; its cell is that of the piece it bounds
  SideOf shows = SideOf::front;  ///< the side with its colour and part: front for a socket, back for the part itself
};

/// A cut fruit, and its spared parts.
struct SparedFruit {
  CutFruit fruit;                     ///< with vertices for the walls; its section still goes through the spared parts
  std::vector<SparedWall> walls;      ///< of all spared parts
  std::vector<std::uint8_t> uncut;    ///< per triangle of the section: 1 inside a spared part; no piece has it
  std::vector<std::string> warnings;  ///< parts that cannot be spared
};

/// Cells that hold at least this share of the largest share of a shell's volume count as equal.
constexpr double nearly_as_much = 0.95;

/// Per triangle of the surfaces, the closed shell around one of these parts that it is of, numbered from 1 in the order
/// of their first triangles; 0 of none. Whether a shell crosses another or leaves the fruit is not asked.
/// \param parts ascending.
std::vector<std::uint32_t> closed_shells(const DiffusionSurfaces& surfaces, std::span<const int> parts);

/// Finds the spared parts. Each closed shell with one of `parts` behind it and another part before it encloses one. It
/// goes to the cell that contains most of its volume; if several cells contain nearly as much (within a twentieth), to
/// the first in the order of cutting. A shell that is open, crosses another spared shell or leaves the fruit is cut
/// through. The fruit must still have all its surfaces, also inner ones. \param parts sorted.
SparedFruit spared(CutFruit fruit, const DiffusionSurfaces& surfaces, std::span<const int> parts);

}  // namespace pomona
