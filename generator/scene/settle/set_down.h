// Setting a piece down on a dish without letting it fall.
#pragma once

#include <glm/vec3.hpp>

#include "generator/mesh/box.h"
#include "generator/piece/solid.h"
#include "generator/scene/settle/dish.h"
#include "generator/scene/settle/rigid_body.h"

namespace pomona {

/// Moved along a direction of length 1 until it touches the dish: out of it first, then towards it by what it is clear
/// of it, and where it slides along a wall by a little.
void set_down(RigidBody& body, const Dish& dish, const glm::dvec3& away);

/// Out of the dish by all vertices: samples miss the tip of what is pointed.
void lift_out(RigidBody& body, const Solid& solid, const Dish& dish, const glm::dvec3& away);

/// The box around a piece as it is turned: by its samples, because that of its body is one around a turned box.
Box<double> tight_box(const RigidBody& body);

}  // namespace pomona
