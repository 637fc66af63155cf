// A piece as it falls.
#pragma once

#include <cstdint>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/piece/pose.h"
#include "generator/scene/settle/piece_shape.h"

namespace pomona {

enum class BodyState : std::uint8_t {
  active,
  asleep,  ///< at rest until something pushes it
  frozen,  ///< at rest for good: nothing moves it any more
  out      ///< taken out of the heap
};

struct RigidBody {
  RigidBody() = default;  ///< not in the heap
  RigidBody(const PieceShape& of, const glm::dquat& turned, const glm::dvec3& at);

  const PieceShape* shape = nullptr;
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 center{0};             ///< of mass, metres
  glm::dvec3 velocity{0}, spin{0};  ///< metres and radians a step
  BodyState state = BodyState::out;
  bool is_fixed = false;  ///< was set to its place, and stays there whatever is taken out beside it
  int still_steps = 0;    ///< for so many steps it has hardly moved
  double speed = 0;       ///< at most that of its fastest point, metres a step
  double way = 0;         ///< at most that of its fastest point since it was made, metres

  // What follows from rotation and centre.
  glm::mat3 matrix{1};
  glm::dmat3 inverse_inertia{0};
  Box<float> box;

  /// After rotation or centre have changed.
  void refresh();

  /// Where it would be after one step: moves and turns it by its velocity and spin.
  void advance();

  void stop();

  /// Of the solid, which its shape's centre of mass is part of.
  Pose pose() const { return {rotation, center - rotation * shape->center}; }

  bool is_loose() const { return state == BodyState::active || state == BodyState::asleep; }

  /// Of the fastest point, roughly; spin counts half, since few points are far out.
  double motion() const;
};

}  // namespace pomona
