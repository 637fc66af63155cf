// The planes of all knives, in the order in which they cut; and sets of these planes.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "generator/knife/knife.h"
#include "generator/knife/knife_planes.h"
#include "generator/knife/stroke.h"

namespace pomona {

/// The planes of all knives placed at one fruit, knife by knife. Closed knives have no planes.
struct CutPlanes {
  struct Plane {
    CuttingPlane plane;
    int knife = 0;              ///< index into knives
    std::size_t in_knife = 0;   ///< index into that knife's planes
    int same_as = 0;            ///< the first plane that coincides with this one: itself, or one of an earlier knife
    bool turned = false;        ///< its normal is opposite to that of `same_as`
    bool through_axis = false;  ///< it contains the axis x = z = 0 and is not a facet of a stroke
    int blade = 0;              ///< index into blades
  };
  std::vector<Plane> planes;

  /// One cutting surface of a knife: a plane, or all facets of a stroke. It is triangulated in one piece, unrolled.
  struct Blade {
    int first = 0;                 ///< its first plane, an index into planes
    int count = 1;                 ///< number of its planes, which follow each other
    std::optional<Stroke> stroke;  ///< nothing for a plane
  };
  std::vector<Blade> blades;
  std::vector<KnifePlanes> knives;
  double tolerance = 0;  ///< metres; points no farther apart than this count as equal
  double rounding = 0;   ///< metres; largest error of computed points

  int count() const { return static_cast<int>(planes.size()); }
  const Plane& operator[](int plane) const { return planes[static_cast<std::size_t>(plane)]; }
  const Blade& blade_of(int plane) const { return blades[static_cast<std::size_t>((*this)[plane].blade)]; }

  /// The facet of a stroke that the plane is, or null.
  const Stroke::Facet* facet(int plane) const;

  /// True if a point of the plane lies in the plane's facet. Always true for a plane that is not a facet.
  bool is_in_facet(int plane, const glm::dvec3& place) const;
};

/// Places all knives at a fruit with these bounds.
/// \throws Error (usage) for slices that the fruit cannot give, for strokes that run along another knife's plane, and
/// for knives that make more than ten thousand cells.
CutPlanes cut_planes(std::span<const Knife> knives, const Box<double>& bounds);

/// n.p - D in metres.
double signed_distance(const CuttingPlane& plane, const glm::dvec3& point);

/// The point with exact coordinates where its planes determine them: an axis-aligned plane determines one coordinate,
/// two planes through the axis determine x and z.
/// \param on the planes on which the point lies, up to rounding.
glm::dvec3 snapped_to_planes(glm::dvec3 point, const std::vector<int>& on, const CutPlanes& planes);

/// Numbered sets of planes, each stored once: the planes on which a point lies, or that cut an edge. Set 0 is empty.
/// Planes through the axis have one line in common, so a set with two of them has all of them.
class PlaneSets {
 public:
  explicit PlaneSets(const CutPlanes& planes);

  std::uint32_t with(std::uint32_t set, int plane);

  /// The set of one plane, for edges that planes cut: an edge on the axis lies on all planes through it, but only those
  /// that separate its triangle from another cut it.
  std::uint32_t with_alone(std::uint32_t set, int plane);
  std::uint32_t common(std::uint32_t first, std::uint32_t second);
  bool has(std::uint32_t set, int plane) const;
  bool on_axis(std::uint32_t set) const;
  const std::vector<int>& planes_in(std::uint32_t set) const { return sets_[set]; }

 private:
  std::uint32_t number_of(std::vector<int> set);

  std::vector<int> axis_planes_;
  std::vector<std::vector<int>> sets_{{}};
  std::map<std::vector<int>, std::uint32_t> numbers_{{{}, 0}};
};

}  // namespace pomona
