// A dish of any shape: a crate, a tray, a board, a belt, a hill.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/mesh/triangle_tree.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/distance_grid.h"

namespace pomona {

/// Described by a distance grid of its mesh, and by a height map of its upper side. Its hollow is where water would
/// stay if no hole let it out downwards [Barnes et al. 2014, priority-flood].
class MeshDish {
 public:
  /// A cell of the height map in which pieces may lie.
  struct Place {
    glm::dvec2 at{0};  ///< middle of the cell: x and z, metres
    double inset = 0;  ///< distance to the border of all such cells, about, metres
    double level = 0;  ///< height of the rim, or of the surface under the cell, metres above the ground
  };

  /// \param solid stands on y = 0.
  /// \param on_top whether pieces lie on it; else they lie in its hollow.
  MeshDish(const Solid& solid, const TriangleTree& mesh, bool on_top);

  /// The distance from the mesh without the ground, metres. Far away it is a lower bound.
  float distance(const glm::vec3& point) const { return distance_.value(point); }
  glm::vec3 direction(const glm::vec3& point) const { return distance_.direction(point); }

  /// The height of the upper side, metres; 0 beside the dish.
  double height(double x, double z) const;

  /// Whether a point is within the outline seen from above, with an error of up to a cell's width.
  bool covers(double x, double z) const;

  /// The cells in which pieces may lie. Empty if pieces are to lie in a hollow and there is none.
  const std::vector<Place>& places() const { return places_; }

  double cell_area() const { return cell_ * cell_; }  ///< square metres
  const Box<double>& box() const { return box_; }

 private:
  std::optional<std::size_t> cell_at(double x, double z) const;
  void measure_heights(const TriangleTree& mesh);
  void find_outline();
  std::vector<double> water_levels() const;
  void find_places(bool on_top);

  Box<double> box_;
  DistanceGrid distance_;
  double cell_ = 1;                   ///< width of a cell, metres
  glm::ivec2 count_{0};               ///< number of cells along x and z
  std::vector<double> height_;        ///< height of each cell, metres; below 0 where there is no mesh
  std::vector<std::uint8_t> inside_;  ///< per cell: 1 within the outline
  std::vector<Place> places_;
};

}  // namespace pomona
