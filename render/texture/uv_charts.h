// Charts: UV parametrisation. A solid's surface is divided into parts, each flattened, for texturing.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/piece/solid.h"
#include "render/texture/uv_parametrization.h"

namespace pomona {

/// Connected triangles, flattened without overlaps: a part of a flat cut face, unchanged; or a region of skin or of a
/// curved cut face, with little stretch. Seen from the air, x to the right and y down.
struct Chart {
  std::int32_t cut_face = -1;            ///< -1: skin
  std::vector<std::uint32_t> triangles;  ///< triangles of the solid
  std::vector<glm::uvec3> corners;       ///< per triangle: indices into `flat`, in the order of its vertices
  std::vector<glm::dvec2> flat;          ///< metres; the least x and the least y are 0
  glm::dvec2 size{0};                    ///< the greatest x and y
  Stretch stretch;

  /// The frame of a flat cut face: the directions of +x and -y in space, and the offsets of x = 0 and y = 0 along them.
  struct Frame {
    glm::dvec3 right{1, 0, 0}, up{0, 1, 0};
    glm::dvec2 origin{0};
  };
  std::optional<Frame> frame;  ///< frame of flat cut faces only

  /// For a cut face: edges (indices into `flat`) across which the cut goes on smoothly in another chart.
  std::vector<glm::uvec2> seams;
};

/// Every triangle is in exactly one chart. The same for any number of threads.
std::vector<Chart> charts_of(const Solid& solid, Threads threads = {});

}  // namespace pomona
