// The cross-section: triangulated cut faces with diffused colours (paper, section 3.2, Figure 3).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/color.h"
#include "generator/cut/section/detail_guide.h"

namespace pomona {

class GuideLattice;

/// The frame of one cut face. u, v, normal are orthonormal and right-handed; the normal points to the knife's positive
/// side.
struct CutFace {
  int knife = 0;
  glm::dvec3 origin{0}, u{1, 0, 0}, v{0, 1, 0}, normal{0, 0, 1};

  /// The facets of one stroke have the same number; all other faces have -1. When the stroke is unrolled, its facets
  /// lie side by side, and `along` is the position of the origin along u.
  int stroke = -1;
  double along = 0;  ///< metres

  bool curved = false;  ///< part of a closed knife's surface that is not flat; the normal is then its mean
};

/// A piece of a cut segment on the section, for ink: its two vertices on one side of it.
struct SectionSegment {
  std::array<std::uint32_t, 2> vertex{};
  std::int32_t surface = 0;  ///< index into surface_names
  bool boundary = false;     ///< the rim of the section
};

/// All cut faces of a fruit as one mesh, each face once. A vertex on cut segments is split into duplicates, one for
/// every fan of triangles between the segments, each with the colour of its side. Vertices with `interior` = 1 get
/// their colours by diffusion. Vertices on a line where two cut faces meet belong to both.
struct CrossSection {
  std::vector<glm::vec3> position;
  std::vector<Color> color;  ///< linear
  std::vector<std::uint8_t> interior;
  std::vector<std::int32_t> part;  ///< index into part_names
  std::vector<DetailGuide> guide;  ///< per vertex; empty if no detail needs it

  /// The ways and layers of its guides at any place; null if no detail needs them (guide_lattice.h).
  std::shared_ptr<const GuideLattice> guide_lattice;

  std::vector<glm::uvec3> triangle;  ///< counter-clockwise seen from the face's normal
  std::vector<std::int32_t> cut;     ///< index into faces

  /// Per triangle: the unit normals at its corners, on the side of the faces' normals; smooth where a face is curved.
  /// Empty if all faces are flat.
  std::vector<std::array<glm::vec3, 3>> normal;

  std::vector<CutFace> faces;  ///< in cut order
  std::vector<SectionSegment> segments;
  std::vector<std::string> part_names;
  std::vector<std::string> surface_names;
};

}  // namespace pomona
