#include "generator/surface/sweep/body_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

constexpr int stretches = 256;  // number of stretches of the axis table; cubic between them, exact to 1e-11 of its
                                // length

glm::dvec2 heading(double lean) { return {reproducible::sin(lean), reproducible::cos(lean)}; }

double place_of_node(int node) { return 2.0 * node / stretches - 1; }

}  // namespace

glm::dvec3 away_from_axis(const glm::dvec3& straight) {
  const double radius = std::sqrt(straight.x * straight.x + straight.z * straight.z);
  return radius > 0 ? glm::dvec3(straight.x / radius, 0, straight.z / radius) : glm::dvec3(1, 0, 0);
}

BodyMap::BodyMap(const Template& fruit) : proportions_(fruit.proportions), bend_(fruit.bend) {
  const HeightRange range = drawn_heights(fruit);
  if (!(range.high > range.low)) return;
  low_ = range.low;
  half_ = 0.5 * (range.high - range.low);
  half_length_ = half_ * proportions_.height_factor();
  changes_proportions_ = !proportions_.are_as_drawn();
  bends_ = bend_.leans();
  twists_ = bend_.twists();
  if (!bends_) return;
  towards_ = {reproducible::cos(bend_.direction), -reproducible::sin(bend_.direction)};

  // Integrates along the axis by Simpson's rule.
  const double step = 2 * half_length_ / stretches;
  axis_.emplace_back(0, low_);
  tangent_.push_back(heading(bend_.lean(-1)));
  for (int i = 0; i < stretches; ++i) {
    const glm::dvec2 middle = heading(bend_.lean(place_of_node(i) + 1.0 / stretches));
    const glm::dvec2 end = heading(bend_.lean(place_of_node(i + 1)));
    axis_.push_back(axis_.back() + (tangent_.back() + 4.0 * middle + end) * (step / 6));
    tangent_.push_back(end);
  }

  // Its mean, by the trapezoidal rule with end correction, lies on the axis of the frame.
  double mean = 0.5 * (axis_.front().x + axis_.back().x) - step / 12 * (tangent_.back().x - tangent_.front().x);
  for (int i = 1; i < stretches; ++i) mean += axis_[static_cast<std::size_t>(i)].x;
  for (glm::dvec2& p : axis_) p.x -= mean / stretches;
  if (bend_.line.empty()) return;

  // A drawn axis may run downwards, or lie: its lowest point is as low as the drawing's.
  const auto lowest = std::min_element(axis_.begin(), axis_.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const double sunk = lowest->y - low_;
  for (glm::dvec2& p : axis_) p.y -= sunk;
}

glm::dvec3 BodyMap::operator()(const glm::dvec3& drawn) const {
  if (is_identity()) return drawn;
  const double place = (drawn.y - low_) / half_ - 1;
  if (!changes_proportions_) return placed(drawn, place);
  const double factor = proportions_.radius_factor(place), moved = proportions_.place(place);
  const glm::dvec3 straight{drawn.x * factor, low_ + (moved + 1) * half_length_, drawn.z * factor};
  return placed(straight, moved);
}

glm::dvec3 BodyMap::placed(const glm::dvec3& straight, double place) const {
  const glm::dvec3 turned = twists_ ? twisted(straight, place) : straight;
  return bends_ ? bent(turned, place) : turned;
}

glm::dvec3 BodyMap::twisted(const glm::dvec3& straight, double place) const {
  const double angle = bend_.twist((place + 1) / 2);
  const double c = reproducible::cos(angle), s = reproducible::sin(angle);
  return {c * straight.x + s * straight.z, straight.y, c * straight.z - s * straight.x};
}

glm::dvec2 BodyMap::axis_at(double place) const {
  // Beyond its ends the axis goes on straight.
  if (place <= -1) return axis_.front() + tangent_.front() * ((place + 1) * half_length_);
  if (place >= 1) return axis_.back() + tangent_.back() * ((place - 1) * half_length_);

  // Between two nodes it is the cubic with their positions and tangents.
  const double at = (place + 1) / 2 * stretches;
  const auto i = static_cast<std::size_t>(std::min(std::floor(at), stretches - 1.0));
  const double t = at - static_cast<double>(i), left = 1 - t, step = 2 * half_length_ / stretches;
  return (1 + 2 * t) * left * left * axis_[i] + t * t * (1 + 2 * left) * axis_[i + 1] +
         t * left * (left * tangent_[i] - t * tangent_[i + 1]) * step;
}

glm::dvec3 BodyMap::bent(const glm::dvec3& straight, double place) const {
  // The part of the offset from the axis that lies in the plane of the bend turns with the section; the rest stays.
  const double inwards = straight.x * towards_.x + straight.z * towards_.y;
  const glm::dvec2 across{straight.x - inwards * towards_.x, straight.z - inwards * towards_.y};
  const glm::dvec2 up = heading(bend_.lean(std::clamp(place, -1.0, 1.0)));
  const glm::dvec2 at = axis_at(place) + inwards * glm::dvec2(up.y, -up.x);
  return {at.x * towards_.x + across.x, at.y, at.x * towards_.y + across.y};
}

}  // namespace pomona
