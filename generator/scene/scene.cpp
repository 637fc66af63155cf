#include "generator/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"

namespace pomona {

namespace {

/// Calls visit(point) for all vertices in their places, instance by instance. A list of them would take more memory
/// than the scene.
template <typename Visit>
void for_each_placed_point(const Scene& scene, const Visit& visit) {
  for (const Instance& instance : scene.instances)
    for (const glm::vec3& p : scene.solids[static_cast<std::size_t>(instance.solid)].position)
      visit(instance.pose.rotation * glm::dvec3(p) + instance.pose.translation);
}

}  // namespace

Scene gathered(std::vector<Solid> solids) {
  Scene scene;
  scene.solids = std::move(solids);
  for (std::size_t i = 0; i < scene.solids.size(); ++i)
    scene.instances.push_back({static_cast<int>(i), Pose{}, scene.solids[i].name});
  scene.view = fitted_view(scene, {0.5, 0.55, 1.0});
  return scene;
}

View fitted_view(const Scene& scene, const glm::dvec3& direction, double aspect) {
  View view;
  view.vertical_field = scene.view.vertical_field;
  view.fitted = true;
  const glm::dvec3 back = glm::length(direction) > 0 ? glm::normalize(direction) : glm::dvec3(0, 0, 1);
  const glm::dvec3 helper = std::fabs(back.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, back)), up = glm::cross(back, right);

  // Look at the middle of what the camera's own axes span.
  Box<double> seen;
  for_each_placed_point(scene, [&](const glm::dvec3& p) {
    seen.add({glm::dot(p, right), glm::dot(p, up), glm::dot(p, back)});
  });
  if (seen.low.x > seen.high.x) return view;
  const glm::dvec3 middle = seen.center();
  view.target = right * middle.x + up * middle.y + back * middle.z;

  // Step back until every point is within the field.
  constexpr double margin = 1.06;
  const double half = 0.5 * view.vertical_field;
  const double slope = reproducible::sin(half) / reproducible::cos(half) / margin;
  double distance = 0;
  for_each_placed_point(scene, [&](const glm::dvec3& p) {
    const glm::dvec3 away = p - view.target;
    const double aside = std::max(std::fabs(glm::dot(away, right)) / aspect, std::fabs(glm::dot(away, up)));
    distance = std::max(distance, glm::dot(away, back) + aside / slope);
  });
  view.eye = view.target + back * std::max(distance, 1e-3);
  return view;
}

}  // namespace pomona
