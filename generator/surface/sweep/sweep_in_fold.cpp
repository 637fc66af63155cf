// Type II sweeps: a closed loop within one fold, swept along the two halves of the vertical loop (paper,
// section 4.1, Figure 7c): P = (1 - xi) I(v) + xi O(v), Theta = theta_c + kappa(v) (theta - theta_c), with xi the
// loop's place between the reference radii of the drawing and kappa the gap between the halves over
// the widest gap, to the power of the taper.
#include <algorithm>
#include <cmath>
#include <string>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/profile.h"
#include "generator/surface/sweep/section_loop.h"
#include "generator/surface/sweep/swept_grid.h"

namespace pomona {

namespace {

/// A fold's loop, prepared for the sweep.
struct FoldLoop {
  int fold = 0;
  double center = 0;            ///< radians
  std::vector<double> turn;     ///< angle from the centre
  std::vector<double> outness;  ///< 0 at the inner reference radius, 1 at the outer one
};

struct FoldSpan {
  double from = 0, to = 0;
};

FoldSpan span_of(const FoldSymmetry& folds, std::size_t k) {
  const std::vector<double>& angles = folds.fold_angles;
  return {angles[k], k + 1 < angles.size() ? angles[k + 1] : angles[0] + 2 * pi};
}

/// Angles of the loop's points, each next to `near`.
std::vector<double> angles_near(const std::vector<glm::dvec2>& points, double near) {
  std::vector<double> angles;
  for (const glm::dvec2& p : points) {
    const double angle = angle_of(p);
    angles.push_back(angle - 2 * pi * std::round((angle - near) / (2 * pi)));
  }
  return angles;
}

/// The reason why a loop cannot be swept in its fold, or nothing.
std::string fault(const Curve& loop, const std::vector<double>& angles, const FoldSpan& span) {
  if (!loop.closed || loop.points.size() < 3) return "is not a closed curve";
  if (encloses(loop, glm::dvec2(0))) return "surrounds the axis";
  constexpr double rounding = 1e-9;
  for (const double angle : angles) {
    if (angle < span.from - rounding || angle > span.to + rounding) return "leaves its fold";
  }
  return {};
}

FoldLoop sampled_fold_loop(const Curve& loop, const FoldSpan& span, const ReferenceRadii& reference, int around) {
  const std::vector<glm::dvec2> points = resampled(counter_clockwise(loop), around).points;
  FoldLoop sampled;
  sampled.turn = angles_near(points, 0.5 * (span.from + span.to));
  const auto [min, max] = std::minmax_element(sampled.turn.begin(), sampled.turn.end());
  sampled.center = 0.5 * (*min + *max);
  for (double& turn : sampled.turn) turn -= sampled.center;

  const double depth = reference.outer - reference.inner;
  for (const glm::dvec2& p : points) sampled.outness.push_back((glm::length(p) - reference.inner) / depth);
  return sampled;
}

void append(SweptGrid& grid, const glm::dvec2& at, double angle, double along, double around, bool pole) {
  const glm::dvec2 direction = direction_of(angle);
  grid.position.emplace_back(at.x * direction.x, at.y, -at.x * direction.y);
  grid.along.push_back(along);
  grid.around.push_back(around);
  grid.is_pole.push_back(pole ? 1 : 0);
  grid.turn.push_back(turn_of(angle));
}

/// The distance of each vertex from the axis; the arcs meet at the poles.
std::vector<double> depths(const FoldLoop& loop, std::size_t rings) {
  std::vector<double> depths{0.5};
  for (std::size_t j = 1; j + 1 < rings; ++j) {
    for (const double outness : loop.outness) depths.push_back(std::clamp(outness, 0.0, 1.0));
  }
  depths.push_back(0.5);
  return depths;
}

SweptGrid swept_fold(const FoldLoop& loop, const ProfileArcs& arcs, double taper) {
  double widest = 0;
  for (std::size_t j = 0; j < arcs.share.size(); ++j) {
    widest = std::max(widest, glm::distance(arcs.inner[j], arcs.outer[j]));
  }

  SweptGrid grid;
  const std::size_t around = loop.turn.size(), rings = arcs.share.size();
  append(grid, arcs.inner.front(), loop.center, 0, 0, true);
  for (std::size_t j = 1; j + 1 < rings; ++j) {
    const double gap = glm::distance(arcs.inner[j], arcs.outer[j]);
    const double narrowing = gap > 0 ? reproducible::pow(gap / widest, taper) : 0;
    for (std::size_t i = 0; i < around; ++i) {
      glm::dvec2 at = arcs.inner[j] + (arcs.outer[j] - arcs.inner[j]) * loop.outness[i];
      at.x = std::max(at.x, 0.0);  // loops of a variant may reach further in than the drawing's
      const double share = static_cast<double>(i) / static_cast<double>(around);
      append(grid, at, loop.center + narrowing * loop.turn[i], arcs.share[j], share, false);
    }
  }
  append(grid, arcs.inner.back(), loop.center, 1, 0, true);
  grid.fold.assign(grid.position.size(), loop.fold);
  grid.depth = depths(loop, rings);
  grid.triangle = grid_triangles({static_cast<int>(around), static_cast<int>(rings), true, true, false});
  return grid;
}

}  // namespace

std::vector<SweptGrid> swept_in_folds(const Template& fruit, const SurfaceSketch& sketch, int around, int along) {
  // All folds together need a list of loops, one for each, and a closed profile on the right of the axis.
  const auto* folds = std::get_if<FoldSymmetry>(&fruit.symmetry);
  if (!folds || sketch.horizontal.size() != folds->fold_angles.size()) {
    refuse(fruit, sketch, "a surface in a fold needs one horizontal curve for each fold", "draw one loop in each fold");
  }
  if (!sketch.vertical.closed || signed_area(sketch.vertical) == 0) {
    refuse(fruit, sketch, "the vertical curve of a surface in a fold is not a closed loop", "close it");
  }
  for (const glm::dvec2& p : sketch.vertical.points) {
    if (p.x < 0) refuse(fruit, sketch, "the vertical curve crosses the axis", "draw it on the right of the axis");
  }

  // A loop's place between these radii is its place between the two halves of the profile.
  const ReferenceRadii reference = reference_radii(sketch);
  if (!(reference.outer > reference.inner)) {
    refuse(fruit, sketch, "the horizontal curves have no depth", "draw closed loops");
  }

  // Each fold's loop is swept by itself; a fold may be without one.
  const ProfileArcs arcs = sampled_arcs(sketch.vertical, along);
  std::vector<SweptGrid> grids;
  for (std::size_t k = 0; k < sketch.horizontal.size(); ++k) {
    const Curve& loop = sketch.horizontal[k];
    if (loop.points.empty()) continue;
    const FoldSpan span = span_of(*folds, k);
    const std::string why = fault(loop, angles_near(loop.points, 0.5 * (span.from + span.to)), span);
    if (!why.empty()) {
      refuse(fruit, sketch, "the horizontal curve of fold " + std::to_string(k) + " " + why,
             "draw each loop between its two fold lines");
    }
    FoldLoop sampled = sampled_fold_loop(loop, span, reference, around);
    sampled.fold = static_cast<int>(k);
    grids.push_back(swept_fold(sampled, arcs, sketch.taper));
  }
  return grids;
}

}  // namespace pomona
