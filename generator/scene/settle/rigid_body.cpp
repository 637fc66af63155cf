#include "generator/scene/settle/rigid_body.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace pomona {

RigidBody::RigidBody(const PieceShape& of, const glm::dquat& turned, const glm::dvec3& at)
    : shape(&of), rotation(turned), center(at), state(BodyState::active) {
  refresh();
}

void RigidBody::refresh() {
  const glm::dmat3 turn = glm::mat3_cast(rotation);
  matrix = glm::mat3(turn);
  inverse_inertia = turn * shape->inverse_inertia * glm::transpose(turn);

  // The axis-aligned box around the rotated box of the shape.
  const glm::vec3 middle = matrix * shape->box.center() + glm::vec3(center), half = 0.5f * shape->box.size();
  const glm::vec3 reach = glm::abs(matrix[0]) * half.x + glm::abs(matrix[1]) * half.y + glm::abs(matrix[2]) * half.z;
  box = {middle - reach, middle + reach};
}

void RigidBody::advance() {
  center += velocity;
  rotation += 0.5 * (glm::dquat(0, spin.x, spin.y, spin.z) * rotation);
  rotation = rotation * (1 / std::sqrt(glm::dot(rotation, rotation)));
  speed = glm::length(velocity) + shape->radius * glm::length(spin);
  travelled += speed;
  refresh();
}

void RigidBody::stop() {
  velocity = spin = glm::dvec3(0);
  speed = 0;
}

double RigidBody::typical_speed() const {
  return std::max(glm::length(velocity), 0.5 * shape->radius * glm::length(spin));
}

}  // namespace pomona
