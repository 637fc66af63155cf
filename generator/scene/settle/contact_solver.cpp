#include "generator/scene/settle/contact_solver.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

ContactSolver::Axis ContactSolver::axis(const ContactBodies& ends, const glm::vec3& direction) const {
  const BodyMotion &a = motions_[ends.first], &b = motions_[ends.second];
  Axis axis;
  axis.direction = direction;
  axis.first_lever = glm::cross(ends.first_arm, direction);
  axis.second_lever = glm::cross(ends.second_arm, direction);
  axis.first_response = a.inverse_inertia * axis.first_lever;
  axis.second_response = b.inverse_inertia * axis.second_lever;
  axis.effective_mass = 1 / (a.inverse_mass + b.inverse_mass + glm::dot(axis.first_lever, axis.first_response) +
                             glm::dot(axis.second_lever, axis.second_response));
  return axis;
}

void ContactSolver::add(const Contact& contact, const ContactBodies& ends, float friction, float separation) {
  const glm::vec3 normal = glm::normalize(contact.normal);
  const glm::vec3 aside = std::fabs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 along = glm::normalize(glm::cross(normal, aside));
  Row row{ends.first, ends.second, {}, friction, 0, contact.distance};
  row.axis = {axis(ends, normal), axis(ends, along), axis(ends, glm::cross(normal, along))};

  // Bodies that are apart may approach until they touch; bodies that penetrate are moved apart.
  row.target = contact.distance > 0 ? -contact.distance : separation;
  if (contact.is_persistent && glm::dot(contact.impulse, normal) >= 0)
    for (Axis& each : row.axis) apply(row, each, glm::dot(contact.impulse, each.direction));
  rows_.push_back(row);
}

float ContactSolver::speed(const Row& row, const Axis& axis) const {
  const BodyMotion &a = motions_[row.first], &b = motions_[row.second];
  return glm::dot(axis.direction, a.velocity - b.velocity) + glm::dot(axis.first_lever, a.spin) -
         glm::dot(axis.second_lever, b.spin);
}

/// Adds an impulse along the axis and changes both motions by it.
void ContactSolver::apply(const Row& row, Axis& axis, float impulse) {
  BodyMotion &a = motions_[row.first], &b = motions_[row.second];
  axis.impulse += impulse;
  a.velocity += axis.direction * (impulse * a.inverse_mass);
  a.spin += axis.first_response * impulse;
  b.velocity -= axis.direction * (impulse * b.inverse_mass);
  b.spin -= axis.second_response * impulse;
}

/// The normal impulse never pulls. The friction impulse is at most the coefficient times the normal impulse [Coulomb].
void ContactSolver::solve(Row& row) {
  Axis& normal = row.axis[0];
  const float pushed = std::max(0.0f, normal.impulse + normal.effective_mass * (row.target - speed(row, normal)));
  apply(row, normal, pushed - normal.impulse);
  const float max_friction = row.friction * normal.impulse;
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
    Axis& along = row.axis[k];
    const float held =
        std::clamp(along.impulse - along.effective_mass * speed(row, along), -max_friction, max_friction);
    apply(row, along, held - along.impulse);
  }
}

void ContactSolver::sweep(bool forward) {
  if (forward) {
    for (Row& row : rows_) solve(row);
  } else {
    for (std::size_t i = rows_.size(); i-- > 0;) solve(rows_[i]);
  }
}

void ContactSolver::relax() {
  for (Row& row : rows_) {
    row.distance += speed(row, row.axis[0]);
    row.target = std::min(0.0f, -row.distance);
  }
}

glm::vec3 ContactSolver::impulse(std::size_t contact) const {
  glm::vec3 sum(0);
  for (const Axis& axis : rows_[contact].axis) sum += axis.direction * axis.impulse;
  return sum;
}

}  // namespace pomona
