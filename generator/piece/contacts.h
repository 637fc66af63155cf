// Where the pieces of a cut fruit touch, before they are taken apart.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// The number that stands in for a cut face's where pieces touch around a spared part: a stone and its socket.
constexpr std::int32_t around_spared = -1;

/// What two pieces share of one cut face, or of the surfaces of spared parts.
struct PieceContact {
  int first = 0, second = 0;  ///< indices of the pieces, first < second
  std::int32_t cut = 0;       ///< number of the cut face, or around_spared
  double area = 0;            ///< square metres
  using PartPair = std::pair<std::int32_t, std::int32_t>;
  std::map<PartPair, double> parts;  ///< the same by the parts of the first and the second piece, at the corners of
                                     ///< the triangles; those of a cut face are one part
  glm::dvec3 center{0};              ///< of the shared area, metres, in the fruit's frame
};

/// The contacts of pieces as they grew, by pieces and then by cut faces: triangles that two pieces have, one turned
/// over. All areas on cut faces add up to those of the section, where every cut face lies between two pieces; those
/// around spared parts to the walls of all sockets.
std::vector<PieceContact> contacts_of(std::span<const Solid> pieces);

}  // namespace pomona
