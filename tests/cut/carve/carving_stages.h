// A fruit and a closed knife with the results of all steps of carving; and where things lie, computed independently by
// solid angles.
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

/// The colour on the front of all surfaces of a CarvingCase: a linear function of place, as the one on the back is.
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

/// The case with this name.
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
  std::vector<std::vector<int>> winding;  ///< of the knife, for each part of each facet
  SplitFruit split;
  Face face;
  int first_calls = 0;  ///< how often regions() has asked what is known of a triangle of the knife

  /// The regions of the face. They begin with inside_at() of one triangle's middle.
  Regions regions();

  /// The winding numbers of bodies at a place on the knife, in its cell without the present knife. Where the knife only
  /// touches the fruit, as if it had moved by a small step.
  std::vector<CellBoundary> inside_at(const glm::dvec3& place) const;

  /// The winding number of the knife at a place of the fruit, as if it had moved by that step.
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

/// The winding number of closed surfaces at a place that does not lie on them, by solid angles.
int winding_around(std::span<const Corners> triangles, const glm::dvec3& place);

/// Half the product of two edges: the area, along the normal.
glm::dvec3 area_of(const Corners& triangle);

/// True where rounding has made a line of a triangle: then it has no front.
bool is_collapsed(const Corners& triangle);

}  // namespace pomona::shapes
