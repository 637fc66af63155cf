// Where the pieces of a cut fruit touch, before they are taken apart.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// What two pieces share of one cut face.
struct PieceContact {
  int first = 0, second = 0;             ///< indices of the pieces, first < second
  std::int32_t cut = 0;                  ///< number of the cut face
  double area = 0;                       ///< square metres
  std::map<std::int32_t, double> parts;  ///< the same by part, at the corners of the triangles
  glm::dvec3 center{0};                  ///< of the shared area, metres, in the fruit's frame
};

/// The contacts of pieces as they grew, by pieces and then by cut faces: triangles of the section that two pieces have
/// on their faces, one turned over. All areas add up to that of the section, where every cut face lies between two
/// pieces.
std::vector<PieceContact> contacts_of(std::span<const Solid> pieces);

}  // namespace pomona
