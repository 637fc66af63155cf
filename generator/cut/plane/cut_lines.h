// Lines in which cutting planes meet, the creases between a stroke's facets among them. Both planes must have the very
// same points there: they are laid out once, before either plane is triangulated.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "generator/cut/section/segments.h"

namespace pomona {

struct CutLine {
  std::vector<int> planes;  ///< the two that meet, or all that contain the axis; ascending
  glm::dvec3 origin{0}, direction{0, 1, 0};
  std::vector<std::uint32_t> points;  ///< of the split mesh, in order; at least two

  /// Where the line ends because a facet does, along its direction; or infinity: then the first point, or the last,
  /// lies outside the fruit.
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool begins_outside() const { return std::isinf(low); }
  bool ends_outside() const { return std::isinf(high); }

  /// True if what joins points[i - 1] and points[i] leads outside.
  bool leads_outside(std::size_t i) const {
    return (i == 1 && begins_outside()) || (i + 1 == points.size() && ends_outside());
  }
};

/// Lines, and the mesh with the points that they have put into it.
struct CutLines {
  SplitMesh mesh;
  std::vector<CutLine> lines;
};

/// Where the planes that have segments meet within `bounds`: with all points that surfaces have there, and those
/// where three planes meet.
CutLines cut_lines(SplitMesh mesh, const CutPlanes& planes, const std::vector<std::vector<CutSegment>>& segments,
                   const Box<double>& bounds);

/// The length that edges should have on one of the line's planes, at a place.
using SizeOnPlane = std::function<double(int plane, const glm::dvec3& place)>;

/// With points added until neighbours are no farther apart than 1.2 times what `size` says between them, on the plane
/// that asks for least; but for what leads outside.
CutLines subdivided(CutLines all, const CutPlanes& planes, const SizeOnPlane& size);

/// Points of the split mesh that lie on a line, by its number, and are news to other planes there.
using Unshared = std::map<std::size_t, std::vector<std::uint32_t>>;

/// With these points at their places along their lines.
CutLines with_points(CutLines all, const Unshared& points);

/// The points of the line strictly between two of its points, on the way from the first to the second.
std::vector<std::uint32_t> points_between(const CutLine& line, std::uint32_t from, std::uint32_t to);

}  // namespace pomona
