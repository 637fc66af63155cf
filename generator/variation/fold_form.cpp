#include "generator/variation/fold_form.h"

#include <algorithm>

#include "generator/base/units.h"

namespace pomona {

namespace {

Curve in_pie(const PolarCurve& fold, double pie, bool closed) {
  PolarCurve placed = fold;
  for (double& azimuth : placed.azimuth) azimuth *= pie;
  return from_polar(placed, closed);
}

/// How far the curve stays from the fold lines; open curves without their ends, which lie on them.
double distance_from_lines(const PolarCurve& fold, bool closed) {
  const std::ptrdiff_t ends = closed ? 0 : 1;
  const auto [least, most] = std::minmax_element(fold.azimuth.begin() + ends, fold.azimuth.end() - ends);
  return std::min(*least, 1 - *most);
}

double least_radius(const PolarCurve& fold) { return *std::min_element(fold.radius.begin(), fold.radius.end()); }

}  // namespace

FoldForm::FoldForm(const FoldSamples& drawn) : closed_(drawn.closed), margin_(1), least_radius_(1e9) {
  // Any angle below a whole turn shows the same crossings.
  pie_ = std::min(2 * pi / static_cast<double>(drawn.fold.size()), pi);
  for (const PolarCurve& fold : drawn.fold) {
    if (fold.size() == 0) continue;
    simple_ = simple_ && is_simple(in_pie(fold, pie_, closed_));
    margin_ = std::min(margin_, distance_from_lines(fold, closed_));
    least_radius_ = std::min(least_radius_, least_radius(fold));
  }
}

bool FoldForm::is_kept(const PolarCurve& fold) const {
  if (fold.size() == 0) return true;
  if (least_radius(fold) < 0.2 * least_radius_) return false;
  if (margin_ > 0 && distance_from_lines(fold, closed_) <= (closed_ ? 0.5 * margin_ : 0)) return false;
  const Curve curve = in_pie(fold, pie_, closed_);
  if (closed_ && !(signed_area(curve) > 0)) return false;
  return !simple_ || is_simple(curve);
}

}  // namespace pomona
