// Where two pieces touch, or a piece and the dish: samples of one in the distances of the other.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

struct Contact {
  int sample = 0;        ///< which it is, from step to step
  glm::vec3 point{0};    ///< metres
  glm::vec3 normal{0};   ///< pushes the first body off the second
  float distance = 0;    ///< metres, negative where they overlap
  glm::vec3 impulse{0};  ///< that the last step ended with, for the next one to start from
  bool lasting = false;  ///< it was one at the last step too
  bool presses = false;  ///< the step ended with a push, not only near
};

/// Contacts nearer than `margin`, four at most on either body: the deepest, and others far from it and each other.
/// Those in `before` are preferred.
struct PairContacts {
  std::vector<Contact> contact;
  float clear = 0;  ///< if there are none: all samples are at least so far away, metres
};
PairContacts contacts_between(const RigidBody& a, const RigidBody& b, float margin, const std::vector<Contact>& before);

/// The same with the dish; six at most.
std::vector<Contact> contacts_with(const Dish& dish, const RigidBody& body, float margin,
                                   const std::vector<Contact>& before);

/// The least distance, negative where they overlap, if it is below `within`; else `within`.
float distance_between(const RigidBody& a, const RigidBody& b, float within);
float distance_to(const Dish& dish, const RigidBody& body, float within);

}  // namespace pomona
