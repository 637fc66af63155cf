// The visible area of a piece from each direction.
#pragma once

#include <array>
#include <cstddef>

#include <glm/vec3.hpp>

#include "generator/piece/solid.h"

namespace pomona {

/// The areas of a piece's cut faces and of its skin, by the direction of the normal: 6 x 6 directions on each side of a
/// cube. Occlusion is ignored.
class SideAreas {
 public:
  explicit SideAreas(const Solid& solid);

  struct Seen {
    double cut = 0, skin = 0;  ///< square metres, as they appear from far away
  };
  Seen from(const glm::dvec3& direction) const;  ///< unit length, in the piece's frame

  double cut() const { return cut_; }    ///< all of it, square metres
  double skin() const { return skin_; }  ///< likewise; walls of cavities count as skin

 private:
  static constexpr std::size_t across = 6, count = 6 * across * across;
  static std::size_t bin(const glm::dvec3& direction);

  std::array<glm::dvec3, count> cut_by_{}, skin_by_{};  ///< sums of area vectors
  double cut_ = 0, skin_ = 0;
};

}  // namespace pomona
