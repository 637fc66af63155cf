// Impulses at contacts, found one after another, again and again, until they agree [Catto 2005, sequential impulses].
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/scene/settle/contact.h"

namespace pomona {

/// A body while impulses act on it. What nothing moves has zeros everywhere.
struct Motion {
  glm::vec3 velocity{0}, spin{0};  ///< metres and radians a step
  float inverse_mass = 0;
  glm::mat3 inverse_inertia{0};
};

/// Two motions by index, and the arms from their centres to a contact.
struct ContactEnds {
  std::size_t first = 0, second = 0;
  glm::vec3 first_arm{0}, second_arm{0};
};

class ContactSolver {
 public:
  explicit ContactSolver(std::vector<Motion> motions) : motions_(std::move(motions)) {}

  /// Starts from the contact's last impulse.
  /// \param push metres a step at which the two are to part.
  void add(const Contact& contact, const ContactEnds& ends, float friction, float push);

  /// All contacts once, in their order or against it.
  void sweep(bool forward);

  /// From here on overlaps push no more: what they have pushed is taken out of the velocities again. The bodies have
  /// moved by these.
  void relax();

  const std::vector<Motion>& motions() const { return motions_; }

  /// In the order in which contacts were added: the impulse on the first body, and the distance after the move.
  glm::vec3 impulse(std::size_t contact) const;
  float distance(std::size_t contact) const { return rows_[contact].distance; }
  bool presses(std::size_t contact) const { return rows_[contact].axis[0].impulse > 0; }

 private:
  /// One direction in which a contact acts.
  struct Axis {
    glm::vec3 direction{0};
    glm::vec3 first_turn{0}, second_turn{0};    ///< how a spin moves the contact along it
    glm::vec3 first_spins{0}, second_spins{0};  ///< what an impulse of 1 adds to the spins
    float mass = 0;                             ///< impulse per change of speed
    float impulse = 0;
  };
  struct Row {
    std::size_t first, second;
    std::array<Axis, 3> axis;  ///< the normal, then two along the surface
    float friction, target, distance;
  };
  Axis axis(const ContactEnds& ends, const glm::vec3& direction) const;
  float speed(const Row& row, const Axis& axis) const;
  void change(const Row& row, Axis& axis, float impulse);
  void solve(Row& row);

  std::vector<Motion> motions_;
  std::vector<Row> rows_;
};

}  // namespace pomona
