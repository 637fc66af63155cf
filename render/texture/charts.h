// Charts: a solid's surface laid flat in parts, for texturing.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/scene/solid.h"
#include "render/texture/flatten.h"

namespace pomona {

/// Connected triangles laid flat without lying on each other: a part of a cut face as it is, or a region of skin with
/// little stretch. As seen from the air, x to the right and y down.
struct Chart {
  std::int32_t cut_face = -1;            ///< -1: skin
  std::vector<std::uint32_t> triangles;  ///< of the solid
  std::vector<glm::uvec3> corners;       ///< per triangle: indices into `flat`, in the order of its vertices
  std::vector<glm::dvec2> flat;          ///< metres; the least x and the least y are 0
  glm::dvec2 size{0};                    ///< the greatest x and y
  Stretch stretch;

  /// Of a cut face: directions in space of +x and of -y, and where its x = 0 and y = 0 lie along them.
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0};
  glm::dvec2 origin{0};
};

/// Every triangle is in exactly one chart. The same for any number of threads.
std::vector<Chart> charts_of(const Solid& solid, Threads threads = {});

}  // namespace pomona
