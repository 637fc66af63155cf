// How the pieces of one entry of a scene are to lie.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace pomona {

enum class PieceArrangementKind : std::uint8_t {
  heap,     ///< let fall, from places drawn
  rows,     ///< set side by side, each as wide as it is
  grid,     ///< set to the knots of a grid
  scatter,  ///< set to places drawn on the upper side of the dish's mesh, each share of its area as likely
  as_cut    ///< in the order in which the knife left them, pulled apart and let fall
};

/// Lengths in metres, in the frame of the dish.
struct PieceArrangement {
  PieceArrangementKind kind = PieceArrangementKind::heap;
  glm::dvec2 at{0};       ///< x and z of its middle
  double turn = 0;        ///< radians about the vertical, as angles run about the axis
  int columns = 0;        ///< of rows and grids; 0 = as many as rows
  glm::dvec2 spacing{0};  ///< of a grid, along a row and from row to row
  double gap = 0.002;     ///< of rows, scatterings and cuts: between neighbours
  double line = 0;        ///< from the line of one cut fruit to the next; 0 = as wide as these are
  double lean = 0.35;     ///< radians by which cut pieces lean backwards when they are let go
  double within = 0;      ///< heaps: dropped within so far of the middle; 0 = anywhere in the dish
};

}  // namespace pomona
