// Contacts between two pieces, or a piece and the dish: samples of one, measured in the distance grid of the other.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

struct Contact {
  int sample = 0;              ///< number of the surface sample; it identifies the contact from step to step
  glm::vec3 point{0};          ///< metres
  glm::vec3 normal{0};         ///< points from the second body to the first
  float distance = 0;          ///< metres, negative where the bodies penetrate
  glm::vec3 impulse{0};        ///< result of the last step; the solver starts from it
  bool is_persistent = false;  ///< the contact existed at the last step, too
  bool is_loaded = false;      ///< the step ended with an impulse; else the bodies are only near
};

/// The contacts of two bodies.
struct PairContacts {
  std::vector<Contact> contacts;
  float clearance = 0;  ///< if there are no contacts: all samples are at least this far away, metres
};

/// Contacts nearer than `margin`, metres; at most four on either body: the deepest, and others that are far from it and
/// from each other. Contacts that are in `before` are preferred.
PairContacts contacts_between(const RigidBody& a, const RigidBody& b, float margin, const std::vector<Contact>& before);

/// The same with the dish; at most six contacts.
std::vector<Contact> contacts_with(const Dish& dish, const RigidBody& body, float margin,
                                   const std::vector<Contact>& before);

/// The smallest distance in metres, negative where the bodies penetrate, if it is below `within`; else `within`.
float distance_between(const RigidBody& a, const RigidBody& b, float within);
float distance_to(const Dish& dish, const RigidBody& body, float within);

}  // namespace pomona
