// A dish of any shape, as settling sees it: a crate, a tray, a board, a belt, a hill.
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

/// Known by the distances of its mesh, and by its upper side on a raster seen from above. What would hold water, were
/// its floor tight, is its hollow [filled as by Barnes et al. 2014].
class MeshDish {
 public:
  /// A cell of the raster in which pieces may lie.
  struct Place {
    glm::dvec2 at{0};  ///< its middle: x and z, metres
    double inset = 0;  ///< metres to the border of all such cells, about
    double level = 0;  ///< metres above the ground: that of the rim, or of the surface under the cell
  };

  /// \param solid stands on y = 0. \param on_top pieces lie on it; else in its hollow.
  MeshDish(const Solid& solid, const TriangleTree& mesh, bool on_top);

  /// Metres from the mesh alone; far away at most that.
  float distance(const glm::vec3& point) const { return distance_.value(point); }
  glm::vec3 direction(const glm::vec3& point) const { return distance_.direction(point); }

  /// Of the upper side; 0 beside it.
  double height(double x, double z) const;

  /// Within its outline as seen from above, up to a cell's width.
  bool covers(double x, double z) const;

  /// None where it has no hollow, and pieces are to lie in one.
  const std::vector<Place>& places() const { return places_; }

  double cell_area() const { return cell_ * cell_; }  ///< square metres
  const Box<double>& box() const { return box_; }

 private:
  std::optional<std::size_t> cell_at(double x, double z) const;
  void look_from_above(const TriangleTree& mesh);
  void find_outline();
  std::vector<double> water_levels() const;
  void find_places(bool on_top);

  Box<double> box_;
  DistanceGrid distance_;
  double cell_ = 1;
  glm::ivec2 count_{0};
  std::vector<double> height_;        ///< of each cell; below 0 where there is no mesh
  std::vector<std::uint8_t> inside_;  ///< within the outline
  std::vector<Place> places_;
};

}  // namespace pomona
