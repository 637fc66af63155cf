#include "generator/scene/settle/contact_solver.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace pomona {

ContactSolver::Axis ContactSolver::axis(const ContactEnds& ends, const glm::vec3& direction) const {
  const Motion &a = motions_[ends.first], &b = motions_[ends.second];
  Axis axis;
  axis.direction = direction;
  axis.first_turn = glm::cross(ends.first_arm, direction);
  axis.second_turn = glm::cross(ends.second_arm, direction);
  axis.first_spins = a.inverse_inertia * axis.first_turn;
  axis.second_spins = b.inverse_inertia * axis.second_turn;
  axis.mass = 1 / (a.inverse_mass + b.inverse_mass + glm::dot(axis.first_turn, axis.first_spins) +
                   glm::dot(axis.second_turn, axis.second_spins));
  return axis;
}

void ContactSolver::add(const Contact& contact, const ContactEnds& ends, float friction, float push) {
  const glm::vec3 normal = glm::normalize(contact.normal);
  const glm::vec3 aside = std::fabs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
  const glm::vec3 along = glm::normalize(glm::cross(normal, aside));
  Row row{ends.first, ends.second, {}, friction, 0, contact.distance};
  row.axis = {axis(ends, normal), axis(ends, along), axis(ends, glm::cross(normal, along))};

  // What is apart may come as near as it is; what overlaps is to part.
  row.target = contact.distance > 0 ? -contact.distance : push;
  if (contact.lasting && glm::dot(contact.impulse, normal) >= 0)
    for (Axis& each : row.axis) change(row, each, glm::dot(contact.impulse, each.direction));
  rows_.push_back(row);
}

float ContactSolver::speed(const Row& row, const Axis& axis) const {
  const Motion &a = motions_[row.first], &b = motions_[row.second];
  return glm::dot(axis.direction, a.velocity - b.velocity) + glm::dot(axis.first_turn, a.spin) -
         glm::dot(axis.second_turn, b.spin);
}

/// Adds to the axis's impulse.
void ContactSolver::change(const Row& row, Axis& axis, float impulse) {
  Motion &a = motions_[row.first], &b = motions_[row.second];
  axis.impulse += impulse;
  a.velocity += axis.direction * (impulse * a.inverse_mass);
  a.spin += axis.first_spins * impulse;
  b.velocity -= axis.direction * (impulse * b.inverse_mass);
  b.spin -= axis.second_spins * impulse;
}

/// The normal never pulls; along the surface, friction holds up to its share of that [Coulomb].
void ContactSolver::solve(Row& row) {
  Axis& normal = row.axis[0];
  const float pressed = std::max(0.0f, normal.impulse + normal.mass * (row.target - speed(row, normal)));
  change(row, normal, pressed - normal.impulse);
  const float most = row.friction * normal.impulse;
  for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
    Axis& along = row.axis[k];
    const float held = std::clamp(along.impulse - along.mass * speed(row, along), -most, most);
    change(row, along, held - along.impulse);
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
