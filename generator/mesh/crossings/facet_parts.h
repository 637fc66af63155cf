// Divides one triangle along the lines in which another body's boundary passes through it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A triangle and the segments that cross it. All points are given by numbers.
struct CrossedFacet {
  /// A segment in which another triangle crosses this one. Seen from the front, the inside of its body is left of it.
  struct Segment {
    std::uint32_t from = 0, to = 0;
    std::int32_t body = 0;  ///< the other triangle's
  };
  std::array<std::uint32_t, 3> corner{};
  std::array<std::vector<std::uint32_t>, 3> border;  ///< further points from corner i to corner i + 1, in this order
  std::vector<Segment> segment;
};

struct FacetPart {
  static constexpr std::int32_t outside = -1;

  std::array<std::uint32_t, 3> corner{};
  std::int32_t inside = outside;  ///< the body that it lies in
};

/// The parts, which turn as the triangle does. What bounds them is exactly the triangle's border and both sides of each
/// segment, whatever rounding has made of the points' places: so triangles that share these points stay closed.
/// Nothing if the segments do not part the triangle into an inside and an outside, because the other body crosses
/// itself there.
std::optional<std::vector<FacetPart>> parts_of(const CrossedFacet& facet, const std::vector<glm::dvec3>& place);

}  // namespace pomona
