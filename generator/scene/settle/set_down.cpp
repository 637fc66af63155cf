#include "generator/scene/settle/set_down.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "generator/scene/settle/contact.h"

namespace pomona {

void set_down(RigidBody& body, const Dish& dish, const glm::dvec3& away) {
  constexpr double min_step = 3e-4, near_enough = 1e-5;  // metres
  const auto clearance_at = [&](const glm::dvec3& center) {
    body.center = center;
    body.refresh();
    return static_cast<double>(distance_to(dish, body, 1.0f));
  };
  double clearance = clearance_at(body.center);
  for (int step = 0; step < 100 && clearance <= 0; ++step)
    clearance = clearance_at(body.center + away * (min_step - clearance));
  glm::dvec3 above = body.center;
  for (int step = 0; step < 10000 && clearance > near_enough; ++step) {
    above = body.center;
    clearance = clearance_at(above - away * std::max(clearance, min_step));
  }

  // The last step may have gone too far.
  glm::dvec3 below = body.center;
  if (clearance >= -near_enough) return;
  while (glm::distance(above, below) > near_enough) {
    const glm::dvec3 middle = 0.5 * (above + below);
    (clearance_at(middle) > 0 ? above : below) = middle;
  }
  clearance_at(above);
}

void lift_out(RigidBody& body, const Solid& solid, const Dish& dish, const glm::dvec3& away) {
  constexpr double near_enough = 1e-5;  // metres
  for (int step = 0; step < 20; ++step) {
    float clearance = 1;
    for (const glm::vec3& p : solid.mesh.position)
      clearance = std::min(
          clearance, dish.distance(glm::vec3(body.rotation * (glm::dvec3(p) - body.shape->center) + body.center)));
    if (clearance > -near_enough) return;
    body.center -= away * static_cast<double>(clearance);
    body.refresh();
  }
}

Box<double> tight_box(const RigidBody& body) {
  Box<double> box;
  for (const glm::vec3& sample : body.shape->samples.point) box.add(glm::dvec3(body.matrix * sample) + body.center);
  return box;
}

}  // namespace pomona
