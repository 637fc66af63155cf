// Lines in which cutting planes intersect; also the creases between a stroke's facets. Both planes need exactly the
// same points there, so these are made once, before either plane is triangulated.
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
  std::vector<int> planes;  ///< the two planes, or all planes that contain the axis; sorted
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

/// The lines, and the mesh with the points that they have added.
struct CutLines {
  SplitMesh mesh;
  std::vector<CutLine> lines;
};

/// The lines inside `bounds` in which planes with segments intersect, with all points that surfaces have on them, and
/// the points where three planes intersect.
CutLines cut_lines(SplitMesh mesh, const CutPlanes& planes, const std::vector<std::vector<CutSegment>>& segments,
                   const Box<double>& bounds);

/// The length that edges should have on one of the line's planes, at a place.
using SizeOnPlane = std::function<double(int plane, const glm::dvec3& place)>;

/// The lines with more points, until neighbours are at most 1.2 times the smallest `size` (over the planes) apart.
/// Parts that lead outside the fruit are not changed.
CutLines subdivided(CutLines all, const CutPlanes& planes, const SizeOnPlane& size);

/// For each line (by number), points of the split mesh on it that the other planes do not have yet.
using Unshared = std::map<std::size_t, std::vector<std::uint32_t>>;

/// The lines with these points inserted.
CutLines with_points(CutLines all, const Unshared& points);

/// The points of the line strictly between two of its points, in the order from the first to the second.
std::vector<std::uint32_t> points_between(const CutLine& line, std::uint32_t from, std::uint32_t to);

}  // namespace pomona
