// The placing of a file's points.
#pragma once

#include <glm/vec3.hpp>

namespace pomona {

struct Placing {
  double unit = 1;    ///< metres of one unit of the file
  bool z_up = false;  ///< the file's Z points up, its Y to the back
  glm::dvec3 at{0};   ///< place of the file's origin, metres

  /// False if every bit, also the sign of zeros, must stay.
  bool moves() const { return z_up || unit != 1 || at != glm::dvec3(0); }
  glm::dvec3 operator()(const glm::dvec3& p) const { return (z_up ? glm::dvec3(p.x, p.z, -p.y) : p) * unit + at; }
};

}  // namespace pomona
