#include "generator/diffusion/morton.h"

namespace pomona {

namespace {

/// Spreads 21 bits so that two zeros follow each.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001f00000000ffffULL;
  bits = (bits | bits << 16) & 0x001f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2) & 0x1249249249249249ULL;
}

}  // namespace

std::uint64_t morton_code(const glm::dvec3& point, const glm::dvec3& low, const glm::dvec3& high) {
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = high[axis] - low[axis];
    const double place = extent > 0 ? (point[axis] - low[axis]) / extent : 0;
    code |= spread(static_cast<std::uint64_t>(place * 2097151.0)) << axis;  // 2^21 - 1
  }
  return code;
}

}  // namespace pomona
