// Placing a piece on a dish without simulating its fall.
#pragma once

#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

/// Moves the body along a direction of length 1 until it touches the dish: first out of the dish, then towards it, by
/// its clearance or by a small step where that is smaller.
void set_down(RigidBody& body, const Dish& dish, const glm::dvec3& away);

/// Moves the body out of the dish until no vertex is inside. Samples alone would miss a sharp tip.
void lift_out(RigidBody& body, const Solid& solid, const Dish& dish, const glm::dvec3& away);

/// The box around the samples of a rotated piece. It is tighter than RigidBody::box, which holds a rotated box.
Box<double> tight_box(const RigidBody& body);

}  // namespace pomona
