#include "generator/template/curve_faults.h"

#include <algorithm>
#include <cmath>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

using MaybeFault = std::optional<CurveFault>;

/// Rounding of an angle drawn exactly on a fold line.
constexpr double angle_slack = 1e-6;

double dot(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.x + a.y * b.y; }

MaybeFault fault_of_loop(const Curve& loop) {
  if (loop.points.size() < 3) return CurveFault{"has too few points", "a loop needs at least three"};
  if (!loop.closed) return CurveFault{"is not closed", "end the path with Z, or join its two ends"};
  if (!is_simple(loop)) return CurveFault{"crosses itself", "redraw it as one simple loop"};
  return {};
}

/// How often the loop crosses the ray from the axis at this angle.
int crossings(const Curve& loop, double angle) {
  const glm::dvec2 ray(reproducible::cos(angle), reproducible::sin(angle));
  int count = 0;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const glm::dvec2& a = loop.points[i];
    const glm::dvec2& b = loop.points[(i + 1) % loop.points.size()];
    const double side_a = cross(ray, a), side_b = cross(ray, b);
    if ((side_a <= 0) == (side_b <= 0)) continue;
    if (dot(ray, a + (b - a) * (side_a / (side_a - side_b))) > 0) ++count;
  }
  return count;
}

std::string in_degrees(double angle) { return std::to_string(std::lround(angle * 180 / pi)) + " degrees"; }

/// The angle's difference from `to`, -pi..pi.
double turned_to(double angle, double to) { return angle - to - 2 * pi * std::round((angle - to) / (2 * pi)); }

}  // namespace

std::optional<CurveFault> fault_of_vertical(const Curve& curve, SurfaceType type) {
  const std::size_t count = curve.points.size();
  if (count < 2) return CurveFault{"has too few points", "draw a curve, not a dot"};
  for (const glm::dvec2& p : curve.points) {
    if (p.x < 0) return CurveFault{"goes left of the axis", "draw it on the right of the axis, x >= 0"};
  }
  if (type == SurfaceType::in_fold) return fault_of_loop(curve);

  // Ends may lie on the axis: there the surface closes. Anywhere else it would pinch.
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_end = !curve.closed && (i == 0 || i + 1 == count);
    if (curve.points[i].x == 0 && !is_end) {
      return CurveFault{"touches the axis between its ends", "let only its two ends lie on the axis, x = 0"};
    }
  }
  if (!is_simple(curve)) return CurveFault{"crosses itself", "redraw it without a crossing"};
  return {};
}

std::optional<CurveFault> fault_of_open_ends(const Curve& curve) {
  if (curve.closed || curve.points.empty()) return {};
  for (const glm::dvec2& end : {curve.points.front(), curve.points.back()}) {
    if (end.x == 0) continue;
    const double other = end.y == curve.points.front().y ? curve.points.back().y : curve.points.front().y;
    const auto tenths = std::to_string(std::lround(end.x * 1e4));
    const std::string gap = (tenths.size() > 1 ? tenths.substr(0, tenths.size() - 1) : "0") + "." + tenths.back();
    return CurveFault{"does not reach the axis at its " + std::string(end.y <= other ? "lower" : "upper") +
                          " end: " + gap + " mm are missing",
                      "draw that end onto the axis, for air lies on one side of this surface"};
  }
  return {};
}

std::optional<CurveFault> fault_of_loop_around_axis(const Curve& loop, const Symmetry& symmetry) {
  if (MaybeFault fault = fault_of_loop(loop)) return fault;
  if (!encloses(loop, {0, 0})) {
    return CurveFault{"does not surround the axis",
                      "draw it around the axis, which is at 0,0 or where the sketch has it"};
  }
  const auto* folds = std::get_if<FoldSymmetry>(&symmetry);
  if (!folds) return {};
  for (std::size_t k = 0; k < folds->fold_angles.size(); ++k) {
    const double angle = folds->fold_angles[k];
    const int count = crossings(loop, angle);
    if (count == 1) continue;
    return CurveFault{"crosses fold line " + std::to_string(k + 1) + ", at " + in_degrees(angle) + ", " +
                          std::to_string(count) + " times",
                      "redraw it so that it crosses each fold line once, or move the fold line"};
  }
  return {};
}

std::optional<CurveFault> fault_of_loop_in_fold(const Curve& loop, const FoldSymmetry& folds, std::size_t k) {
  if (MaybeFault fault = fault_of_loop(loop)) return fault;
  if (encloses(loop, {0, 0})) {
    return CurveFault{"surrounds the axis", "draw it inside its fold, or make the surface \"around-axis\""};
  }
  const std::vector<double>& angles = folds.fold_angles;
  const double from = angles[k], to = k + 1 < angles.size() ? angles[k + 1] : angles[0] + 2 * pi;
  const double middle = 0.5 * (from + to), half = 0.5 * (to - from) + angle_slack;
  for (const glm::dvec2& p : loop.points) {
    if (std::fabs(turned_to(reproducible::atan2(p.y, p.x), middle)) <= half) continue;
    return CurveFault{
        "leaves fold " + std::to_string(k + 1) + ", which spans " + in_degrees(from) + " to " + in_degrees(to),
        "draw it between its two fold lines, counted from +X against the clock"};
  }
  return {};
}

}  // namespace pomona
