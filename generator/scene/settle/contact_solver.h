// Contact impulses, solved one after another in repeated sweeps until they agree [Catto 2005, sequential impulses].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/scene/settle/contact.h"

namespace pomona {

/// The motion of a body while impulses act on it. All fields of a body that cannot move are zero.
struct BodyMotion {
  glm::vec3 velocity{0};  ///< metres a step
  glm::vec3 spin{0};      ///< radians a step
  float inverse_mass = 0;
  glm::mat3 inverse_inertia{0};
};

/// The two bodies of a contact.
struct ContactBodies {
  std::size_t first = 0, second = 0;  ///< indices of motions
  glm::vec3 first_arm{0};             ///< lever arm: from the first body's centre to the contact, metres
  glm::vec3 second_arm{0};            ///< the same from the second body's centre
};

class ContactSolver {
 public:
  explicit ContactSolver(std::vector<BodyMotion> motions) : motions_(std::move(motions)) {}

  /// Adds a contact. A persistent one starts from its last impulse.
  /// \param separation the speed at which two penetrating bodies are moved apart, metres a step.
  void add(const Contact& contact, const ContactBodies& ends, float friction, float separation);

  /// Solves every contact once, in the order in which they were added, or in the reverse order.
  void sweep(bool forward);

  /// Call it when the bodies have moved by their velocities. From here on penetrations are not corrected any more, so
  /// that the next sweeps remove the speed of the correction from the velocities.
  void relax();

  const std::vector<BodyMotion>& motions() const { return motions_; }

  /// The impulse on the first body. Contacts are numbered in the order in which they were added.
  glm::vec3 impulse(std::size_t contact) const;
  /// The distance after the move, metres.
  float distance(std::size_t contact) const { return rows_[contact].distance; }
  /// Whether the contact ended with an impulse along its normal.
  bool is_loaded(std::size_t contact) const { return rows_[contact].axis[0].impulse > 0; }

 private:
  /// One direction in which a contact acts.
  struct Axis {
    glm::vec3 direction{0};
    glm::vec3 first_lever{0};      ///< arm x direction: speed along the axis per spin of the first body
    glm::vec3 second_lever{0};     ///< the same of the second body
    glm::vec3 first_response{0};   ///< change of the first body's spin by an impulse of 1
    glm::vec3 second_response{0};  ///< the same of the second body
    float effective_mass = 0;      ///< impulse per change of speed
    float impulse = 0;             ///< sum of all impulses along this axis so far
  };
  /// One contact in the system of equations.
  struct Row {
    std::size_t first, second;  ///< indices of motions
    std::array<Axis, 3> axis;   ///< the normal, then two tangents
    float friction;             ///< coefficient
    float target;               ///< wanted speed along the normal, metres a step
    float distance;             ///< metres
  };
  Axis axis(const ContactBodies& ends, const glm::vec3& direction) const;
  float speed(const Row& row, const Axis& axis) const;
  void apply(const Row& row, Axis& axis, float impulse);
  void solve(Row& row);

  std::vector<BodyMotion> motions_;
  std::vector<Row> rows_;
};

}  // namespace pomona
