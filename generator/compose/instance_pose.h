// How an instance of a placed template lies in the fruit.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/base/random.h"
#include "generator/compose/place_seats.h"
#include "generator/surface/diffusion_surfaces.h"
#include "generator/template/place_sketch.h"

namespace pomona {

/// From the instance's own frame to the fruit's: turned and scaled about `foot`, which comes to lie at `at`.
struct InstancePose {
  glm::dmat3 turn{1};  ///< columns: where the instance's axes point
  double scale = 1;
  glm::dvec3 foot{0}, at{0};

  glm::dvec3 operator()(const glm::dvec3& own) const { return at + turn * (scale * (own - foot)); }
  glm::dvec3 turned(const glm::dvec3& own) const { return turn * own; }
  glm::dvec3 turned_back(const glm::dvec3& direction) const { return glm::transpose(turn) * direction; }
};

/// \param number of the instance in its place, by which its random numbers are drawn
InstancePose instance_pose(const PlaceSketch& place, const PlaceSeat& seat, const Box<double>& own, std::size_t number,
                           const RandomStream& draws);

}  // namespace pomona
