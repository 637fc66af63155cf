#include "render/picture/view_within.h"

#include <algorithm>

#include "generator/base/reproducible.h"
#include "render/picture/view_frame.h"

namespace pomona {

namespace {

/// Half of the visible height at a distance of one metre, metres.
double half_height(const View& view) {
  const double half = 0.5 * view.vertical_field;
  return reproducible::sin(half) / reproducible::cos(half);
}

}  // namespace

View view_within(const View& view, const glm::dvec2& picture, const glm::dvec2& low, const glm::dvec2& high) {
  View wider = view;
  wider.vertical_field = 2 * reproducible::atan2(half_height(view) * picture.y, std::max(high.y - low.y, 1.0));

  // Moves the eye, so that the target is in the middle of the box.
  const ViewFrame frame = view_frame(view);
  const glm::dvec2 off = (0.5 * (low + high) - 0.5 * picture) / pixels_per_metre(wider, picture.y);
  const glm::dvec3 step = frame.up * off.y - frame.right * off.x;
  wider.eye += step;
  wider.target += step;
  return wider;
}

double pixels_per_metre(const View& view, double picture_height) {
  return 0.5 * picture_height / half_height(view) / view_frame(view).distance;
}

}  // namespace pomona
