// The height map of a heap, seen from above.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

class HeightMap {
 public:
  /// The map of an empty dish: a square around the axis.
  /// \param half half of its width, metres; a piece outside counts as on the border.
  /// \param cell width of a cell, metres.
  HeightMap(const Dish& dish, double half, double cell);

  /// Adds a body: its samples raise the cells that they lie in.
  void raise(const RigidBody& body);

  /// The lowest height of the body's centre above (x, z) at which the body touches nothing below it, metres.
  float resting_height(const RigidBody& body, float x, float z) const;

 private:
  std::size_t at(float x, float z) const;

  float half_;                 ///< half of the map's width, metres
  float cell_;                 ///< width of a cell, metres
  int count_;                  ///< number of cells along a side
  std::vector<float> height_;  ///< height of each cell, metres
};

}  // namespace pomona
