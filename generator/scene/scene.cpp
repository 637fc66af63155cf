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

/// Calls visit(point) for all placed vertices, instance by instance. A list of them would take more memory than the
/// scene.
template <typename Visit>
void for_each_placed_point(const Scene& scene, const Visit& visit) {
  for (const Instance& instance : scene.instances)
    for (const glm::vec3& p : scene.solids[static_cast<std::size_t>(instance.solid)].mesh.position)
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

View fitted_view(const Scene& scene, const glm::dvec3& direction, double aspect,
                 const std::optional<glm::dvec3>& light) {
  View view;
  view.vertical_field = scene.view.vertical_field;
  view.fitted = true;
  const glm::dvec3 back = glm::length(direction) > 0 ? glm::normalize(direction) : glm::dvec3(0, 0, 1);
  const glm::dvec3 helper = std::fabs(back.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, back)), up = glm::cross(back, right);

  // A point that is r to the right and b towards the eye is within a field of slope s for an eye at (R, B) if
  // r - R and R - r are at most s (B - b). So of all points only the largest s b + r and s b - r count; likewise
  // upwards.
  constexpr double margin = 1.06;
  constexpr double penumbra = 0.1;  // a shadow's edge has grown as soft as this share of the height that casts it
  const double half = 0.5 * view.vertical_field;
  const double slope_up = reproducible::sin(half) / reproducible::cos(half) / margin, slope_right = slope_up * aspect;
  constexpr double none = -std::numeric_limits<double>::infinity();
  double to_right = none, to_left = none, above = none, below = none, nearest = none;
  const auto hold = [&](const glm::dvec3& p, double around = 0) {
    const double r = glm::dot(p, right), u = glm::dot(p, up), b = glm::dot(p, back);
    to_right = std::max(to_right, slope_right * b + r + around);
    to_left = std::max(to_left, slope_right * b - r + around);
    above = std::max(above, slope_up * b + u + around);
    below = std::max(below, slope_up * b - u + around);
    nearest = std::max(nearest, b);
  };
  const bool has_shadow = light && scene.ground && light->y > 0.05;
  for_each_placed_point(scene, [&](const glm::dvec3& p) {
    hold(p);
    if (has_shadow && p.y > 0) hold(p - *light * (p.y / light->y), penumbra * p.y);
  });
  if (!(nearest > none)) return view;

  // As near as both fields allow; centred in the one that leaves room.
  const double distance =
      std::max({(to_right + to_left) / (2 * slope_right), (above + below) / (2 * slope_up), nearest + 1e-3});
  view.eye = right * (0.5 * (to_right - to_left)) + up * (0.5 * (above - below)) + back * distance;

  // Looks at the middle of the visible part.
  Box<double> seen;
  for_each_placed_point(scene, [&](const glm::dvec3& p) { seen.add(glm::dvec3(glm::dot(p, back))); });
  view.target = view.eye - back * std::max(distance - seen.center().x, 1e-3);
  return view;
}

}  // namespace pomona
