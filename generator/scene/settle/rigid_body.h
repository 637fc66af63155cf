// One piece as a rigid body.
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
  frozen,  ///< at rest for good: contacts do not move it
  absent   ///< not in the world
};

struct RigidBody {
  RigidBody() = default;  ///< an absent body
  RigidBody(const PieceShape& of, const glm::dquat& turned, const glm::dvec3& at);

  const PieceShape* shape = nullptr;
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 center{0};    ///< centre of mass, metres
  glm::dvec3 velocity{0};  ///< metres a step
  glm::dvec3 spin{0};      ///< angular velocity, radians a step
  BodyState state = BodyState::absent;
  bool is_fixed = false;  ///< it was set to its place and stays there, whatever is removed beside it
  int steps_at_rest = 0;  ///< number of steps since it was last faster than the sleep threshold
  double speed = 0;       ///< upper bound of the speed of its fastest point, metres a step
  double travelled = 0;   ///< upper bound of what any of its points has moved since it was made, metres

  glm::mat3 matrix{1};            ///< follows from the rotation; refresh() computes it
  glm::dmat3 inverse_inertia{0};  ///< in the world's axes; refresh() computes it
  Box<float> box;                 ///< around the body, metres; refresh() computes it

  /// Computes what follows from rotation and centre. Call it after these have changed.
  void refresh();

  /// Moves and turns the body by its velocity and spin, for one step.
  void advance();

  /// Sets velocity and spin to zero.
  void stop();

  /// The pose of the solid. Its origin is not the centre of mass.
  Pose pose() const { return {rotation, center - rotation * shape->center}; }

  bool is_loose() const { return state == BodyState::active || state == BodyState::asleep; }

  /// A typical speed of its fast points, metres a step, for the sleep threshold. Spin counts half, because few points
  /// are far from the centre.
  double typical_speed() const;
};

}  // namespace pomona
