// How the pieces of one entry of a scene are arranged.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace pomona {

enum class PieceArrangementKind : std::uint8_t {
  heap,     ///< dropped from random places
  rows,     ///< placed side by side
  grid,     ///< placed on the nodes of a grid
  scatter,  ///< placed at random on the upper side of the dish's mesh, uniformly by area
  as_cut    ///< in the order in which the knife left them, pulled apart and dropped
};

/// Lengths in metres, in the frame of the dish.
struct PieceArrangement {
  PieceArrangementKind kind = PieceArrangementKind::heap;
  glm::dvec2 at{0};       ///< x and z of the arrangement's middle
  double turn = 0;        ///< rotation about the y axis, radians
  int columns = 0;        ///< rows, grid: pieces in a row; 0 = as many as there are rows
  glm::dvec2 spacing{0};  ///< grid: distance of neighbours along a row, and of two rows
  double gap = 0.002;     ///< rows, scatter, as_cut: distance between neighbours
  double line = 0;  ///< as_cut: distance between the lines of two fruits; 0 = the width of the widest piece and a gap
  double lean = 0.35;  ///< as_cut: angle by which pieces lean backwards when they are dropped, radians
  double within = 0;   ///< heap: pieces are dropped within this distance of the middle; 0 = anywhere in the dish
};

}  // namespace pomona
