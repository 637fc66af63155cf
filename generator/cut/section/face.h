// A cut face: the surface of a knife, triangulated so that its edges follow the fruit's surfaces that pass through it.
// Planes, strokes and closed knives all give such faces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/cut/section/cross_section.h"
#include "generator/cut/section/segments.h"

namespace pomona {

/// A cut segment, or a part of one, that an edge of the triangulation follows.
struct EdgeUse {
  std::uint32_t low = 0, high = 0;  ///< vertices of the face
  std::uint32_t segment = 0;        ///< index into Face::segment
  bool forward = false;             ///< the segment runs from low to high
};

struct Face {
  static constexpr std::int32_t none = -1;

  int plane =
      0;  ///< number among all planes; for a stroke, that of its first facet; a closed knife counts as one plane

  // Per vertex.
  std::vector<glm::dvec3> place;     ///< metres, on the knife's surface
  std::vector<std::uint32_t> point;  ///< of the split mesh

  // Per triangle; edges run from corner i to i + 1.
  std::vector<glm::uvec3> triangle;                      ///< counter-clockwise seen from the knife's positive side
  std::vector<std::array<std::int32_t, 3>> neighbor;     ///< across the edge, or none
  std::vector<std::array<std::uint8_t, 3>> constrained;  ///< the edge is part of a cut segment or of a crease
  std::vector<std::uint32_t> facet;                      ///< index into frame
  std::vector<std::array<glm::vec3, 3>> normal;          ///< of its corners, unit

  /// The frames of its faces in the section: one for a plane, one per facet of a stroke, one per chart of a closed
  /// knife.
  std::vector<CutFace> frame;

  std::vector<CutSegment> segment;
  std::vector<EdgeUse> edges;  ///< sorted by (low, high, segment)

  /// The segments that the edge from p to q follows.
  std::span<const EdgeUse> uses(std::uint32_t p, std::uint32_t q) const;

  /// The end at which the edge of a triangle begins; edge 3 is edge 0.
  std::uint32_t corner(std::size_t triangle_index, std::size_t i) const {
    return triangle[triangle_index][static_cast<int>(i % 3)];
  }

  /// Brings `edges` into their order.
  void sort_edges();
};

/// The distance between two vertices, metres.
double distance(const Face& face, std::uint32_t p, std::uint32_t q);

}  // namespace pomona
