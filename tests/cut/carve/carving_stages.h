// A fruit and a closed knife with all that carving makes of them on its way, step by step; and what lies where, worked
// out once more by solid angles.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/cut/carve/carve.h"
#include "generator/cut/carve/knife_regions.h"
#include "generator/cut/carve/split_surfaces.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/knife/knife.h"
#include "generator/surface/bodies.h"
#include "tests/cut/carve/moved_knife.h"

namespace pomona::shapes {

/// Colours on the fronts and backs of all surfaces of a CarvingCase change evenly from place to place.
Color front_color_at(const glm::dvec3& place);
Color back_color_at(const glm::dvec3& place);

struct CarvingCase {
  std::string name;
  DiffusionSurfaces surfaces;
  std::vector<Knife> before;  ///< knives that have cut the fruit already: planes and closed ones
  ClosedSurface knife;
};

/// Bowls, a hollow and a tube; through bodies with a core, with a cavity, through each other and with a common wall;
/// where planes and another closed knife have cut before; a knife of two parts, and one with a face in a face of the
/// fruit.
std::vector<CarvingCase> carving_cases();

/// The case that is called so.
CarvingCase carving_case(const std::string& name);

class CarvingStages {
 public:
  explicit CarvingStages(const CarvingCase& of);

  DiffusionSurfaces surfaces;
  Bodies bodies;
  CutFruit fruit;  ///< as the knives before have left it
  ClosedKnife knife;
  std::vector<std::uint32_t> surface, cap;  ///< triangles of the fruit and of its section in the arrangement
  ExactPoints places;
  Arrangement all;
  std::vector<std::vector<int>> winding;  ///< of the knife, per facet, per part
  SplitFruit split;
  Face face;
  int first_calls = 0;  ///< how often regions() has asked what is known of a triangle of the knife

  /// Of the face. What it must be told of one triangle is inside_at() the triangle's middle.
  Regions regions();

  /// How often bodies wind around a place on the knife, in the cell that it lies in without the knife at work. As if
  /// the knife had moved by a small step, where it only touches the fruit.
  std::vector<CellBoundary> inside_at(const glm::dvec3& place) const;

  /// How often the knife winds around a place of the fruit, as if it had moved by that step.
  int winding_of_knife_at(const glm::dvec3& place) const;

  /// The middle of a triangle of the face.
  glm::dvec3 middle(std::size_t triangle) const;

 private:
  void arrange();
  std::uint32_t cell_at(const glm::dvec3& place) const;

  std::vector<Knife> before_;
  CutPlanes planes_;
  std::vector<std::vector<Corners>> body_;  // the boundary of each, turned to air
};

/// How often closed surfaces wind around a place that does not lie on them, by solid angles.
int winding_around(std::span<const Corners> triangles, const glm::dvec3& place);

/// Half the product of two edges: the area, along the normal.
glm::dvec3 area_of(const Corners& triangle);

/// True where rounding has closed a triangle to a line: then it has no front.
bool is_collapsed(const Corners& triangle);

}  // namespace pomona::shapes
