// A heap seen from above: how high it is where.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

class HeightMap {
 public:
  /// A square about the axis, with nothing on the dish.
  /// \param half its half width, metres; pieces beyond count as on its border.
  HeightMap(const Dish& dish, double half, double cell);

  /// Adds a body, by its samples.
  void raise(const RigidBody& body);

  /// The lowest height of its centre at which the body clears all that is below, with its centre above the place.
  float resting_height(const RigidBody& body, float x, float z) const;

 private:
  std::size_t at(float x, float z) const;

  float half_, cell_;
  int count_;  ///< cells along a side
  std::vector<float> height_;
};

}  // namespace pomona
