// The planes of all knives in the order they cut: which coincide, which are facets of one blade, and sets of them.
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

/// The planes of all knives laid at one fruit, one after another. Closed knives have none.
struct CutPlanes {
  struct Plane {
    CuttingPlane plane;
    int knife = 0;              ///< index into knives
    std::size_t in_knife = 0;   ///< index into that knife's planes
    int same_as = 0;            ///< the first plane that coincides with this one: itself, or an earlier knife's
    bool turned = false;        ///< its normal points against that plane's
    bool through_axis = false;  ///< contains the axis x = z = 0 and is no facet of a stroke
    int blade = 0;              ///< index into blades
  };
  std::vector<Plane> planes;

  /// One cutting surface of a knife, triangulated as one: a plane, or all facets of a stroke, unrolled.
  struct Blade {
    int first = 0, count = 1;      ///< its planes: planes[first] and those after it
    std::optional<Stroke> stroke;  ///< none for a plane
  };
  std::vector<Blade> blades;
  std::vector<KnifePlanes> knives;
  double tolerance = 0;  ///< metres; places no farther apart than this are one
  double rounding = 0;   ///< metres; computed points are no farther than this from where they should be

  int count() const { return static_cast<int>(planes.size()); }
  const Plane& operator[](int plane) const { return planes[static_cast<std::size_t>(plane)]; }
  const Blade& blade_of(int plane) const { return blades[static_cast<std::size_t>((*this)[plane].blade)]; }

  /// The facet that a plane of a stroke is, or none.
  const Stroke::Facet* facet(int plane) const;

  /// True if a place on the plane lies in the stretch that is the plane's facet; always, where it is no facet.
  bool is_in_facet(int plane, const glm::dvec3& place) const;
};

/// Lays all knives at a fruit with these bounds. \throws Error (usage) for slices the fruit cannot give, for strokes
/// that run along other knives' planes, and where knives make more than ten thousand cells.
CutPlanes cut_planes(std::span<const Knife> knives, const Box<double>& bounds);

/// n.p - D in metres.
double signed_distance(const CuttingPlane& plane, const glm::dvec3& point);

/// The point, which lies `on` these planes up to rounding, with the coordinates set to the bit that they fix: an
/// axis-aligned plane fixes one, two planes through the axis fix x and z.
glm::dvec3 snapped_to_planes(glm::dvec3 point, const std::vector<int>& on, const CutPlanes& planes);

/// Sets of planes by number, each kept once: which planes a point lies on, or an edge is cut by. Set 0 is empty.
/// Planes through the axis meet in one line, so a set with two of them has all of them.
class PlaneSets {
 public:
  explicit PlaneSets(const CutPlanes& planes);

  std::uint32_t with(std::uint32_t set, int plane);
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
