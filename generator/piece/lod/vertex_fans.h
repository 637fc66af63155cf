// A solid's triangles made ready for a half-edge structure, which wants two triangles at an edge and one fan at a
// vertex.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// A fan is a vertex of the half-edge mesh: triangles around one place that hang together by edges. Where bodies of a
/// solid touch, a place has several fans.
struct VertexFans {
  std::vector<glm::uvec3> triangle;     ///< fans at the corners
  std::vector<std::uint32_t> source;    ///< per triangle: which one of the solid it is, ascending
  std::vector<std::uint32_t> vertex;    ///< per fan: a vertex of the solid at its place
  std::vector<std::uint8_t> is_locked;  ///< per fan: 1 where it must stay: beside another fan or a frozen triangle
  std::vector<std::uint32_t> frozen;    ///< triangles of the solid at edges that more than two share
};

/// Triangles with two corners at one place are in neither list. Whatever is done to the fans that are not locked,
/// a closed solid stays closed: an edge between a frozen triangle and another one keeps both ends.
VertexFans vertex_fans(const Solid& solid);

}  // namespace pomona
