// The nearest view that shows all of a scene.
#include "generator/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/mesh/box.h"
#include "generator/scene/placed_boxes.h"

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

constexpr double penumbra = 0.1;       // a shadow's edge has grown as soft as this share of the height that casts it
constexpr double seen_of_reach = 0.8;  // the share of the reach of shade within which it is seen: over 2 of 255

/// The field of a camera that looks along a direction: what of the points that it must hold decides where its eye is. A
/// point that is r to the right and b towards the eye is within a field of slope s for an eye at (R, B) if r - R and
/// R - r are at most s (B - b). So of all points only the largest s b + r and s b - r count; likewise upwards.
class FittedField {
 public:
  /// \param slope of the field's upper border, without its margin.
  FittedField(const glm::dvec3& direction, double slope, double aspect)
      : back_(glm::length(direction) > 0 ? glm::normalize(direction) : glm::dvec3(0, 0, 1)),
        slope_up_(slope / margin),
        slope_right_(slope_up_ * aspect) {
    const glm::dvec3 helper = std::fabs(back_.y) > 0.999 ? glm::dvec3(0, 0, -1) : glm::dvec3(0, 1, 0);
    right_ = glm::normalize(glm::cross(helper, back_));
    up_ = glm::cross(back_, right_);
    level_right_ = level_of(slope_right_ * back_ + right_);
    level_left_ = level_of(slope_right_ * back_ - right_);
    level_above_ = level_of(slope_up_ * back_ + up_);
    level_below_ = level_of(slope_up_ * back_ - up_);
  }

  /// A point, with some room to each side.
  void hold(const glm::dvec3& p, double around = 0) { hold(p, {around, around, around, around, 0}); }

  /// A level disc. What is linear in the place is largest at the centre plus the radius times its level slope.
  void hold_disc(const glm::dvec3& center, double radius) {
    hold(center, {radius * level_right_, radius * level_left_, radius * level_above_, radius * level_below_,
                  radius * level_of(back_)});
  }

  bool is_empty() const { return !(nearest_ > none); }

  /// As near as both fields allow, along the direction.
  double distance() const {
    return std::max(
        {(to_right_ + to_left_) / (2 * slope_right_), (above_ + below_) / (2 * slope_up_), nearest_ + 1e-3});
  }

  /// At that distance, centred in the field that leaves room.
  glm::dvec3 eye(double distance) const {
    return right_ * (0.5 * (to_right_ - to_left_)) + up_ * (0.5 * (above_ - below_)) + back_ * distance;
  }

  const glm::dvec3& back() const { return back_; }

 private:
  /// What a point needs besides itself, metres: in the directions of the field's borders, and towards the eye.
  struct Room {
    double right, left, above, below, back;
  };

  void hold(const glm::dvec3& p, const Room& room) {
    const double r = glm::dot(p, right_), u = glm::dot(p, up_), b = glm::dot(p, back_);
    to_right_ = std::max(to_right_, slope_right_ * b + r + room.right);
    to_left_ = std::max(to_left_, slope_right_ * b - r + room.left);
    above_ = std::max(above_, slope_up_ * b + u + room.above);
    below_ = std::max(below_, slope_up_ * b - u + room.below);
    nearest_ = std::max(nearest_, b + room.back);
  }

  static double level_of(const glm::dvec3& slope) { return std::sqrt(slope.x * slope.x + slope.z * slope.z); }

  static constexpr double margin = 1.06, none = -std::numeric_limits<double>::infinity();
  glm::dvec3 back_, right_{0}, up_{0};
  double slope_up_, slope_right_;
  double level_right_ = 0, level_left_ = 0, level_above_ = 0, level_below_ = 0;
  double to_right_ = none, to_left_ = none, above_ = none, below_ = none, nearest_ = none;
};

}  // namespace

View fitted_view(const Scene& scene, const glm::dvec3& direction, double aspect,
                 const std::optional<glm::dvec3>& light) {
  View view;
  view.vertical_field = scene.view.vertical_field;
  view.fitted = true;
  const double half = 0.5 * view.vertical_field;
  FittedField field(direction, reproducible::sin(half) / reproducible::cos(half), aspect);
  const bool shaded = light && scene.ground, has_shadow = shaded && light->y > 0.05;
  const double reach = shaded ? seen_of_reach * sky_reach(scene) : 0;
  for_each_placed_point(scene, [&](const glm::dvec3& p) {
    field.hold(p);
    if (has_shadow && p.y > 0) field.hold(p - *light * (p.y / light->y), penumbra * p.y);
    if (std::fabs(p.y) < reach) field.hold_disc({p.x, 0, p.z}, std::sqrt(reach * reach - p.y * p.y));
  });
  if (field.is_empty()) return view;
  const double distance = field.distance();
  view.eye = field.eye(distance);

  // Looks at the middle of the visible part.
  Box<double> seen;
  for_each_placed_point(scene, [&](const glm::dvec3& p) { seen.add(glm::dvec3(glm::dot(p, field.back()))); });
  view.target = view.eye - field.back() * std::max(distance - seen.center().x, 1e-3);
  return view;
}

}  // namespace pomona
