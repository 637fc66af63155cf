// The fold lines of a sketch.
#include <cmath>
#include <string>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/template/read/sketch.h"
#include "generator/template/read/sketch_words.h"

namespace pomona {

namespace {

constexpr double min_width = 0.5;  // degrees between two fold lines

/// Three decimals: finer than anyone draws, coarser than rounding. 0..360.
double snapped(double degrees) {
  const double rounded = std::floor(degrees * 1000 + 0.5) / 1000;
  return rounded < 0 ? rounded + 360 : rounded >= 360 ? rounded - 360 : rounded;
}

std::string fold_name(int fold) { return "fold " + std::to_string(fold); }

}  // namespace

/// Counts fold lines, numbered from 1 without gaps.
int Sketch::count_folds() const {
  const auto& named = view_of(SketchView::top).named;
  int count = 0;
  while (count < 64 && named.contains(plain_name(fold_name(count + 1)))) ++count;
  return count;
}

/// The angle on the page, from the right against the clock.
double Sketch::fold_degrees(int fold, const glm::dvec2& axis) const {
  const Placed shape = shape_of(SketchView::top, fold_name(fold));
  const Curve line = on_page(shape);
  glm::dvec2 inner = line.points.front() - axis, outer = line.points.back() - axis;
  if (glm::length(inner) > glm::length(outer)) std::swap(inner, outer);
  if (!(glm::length(inner) < 0.2 * glm::length(outer))) {
    throw BadSketch(called(shape) + " does not start at the axis", "draw each fold line from the axis outwards");
  }
  return snapped(reproducible::atan2(-outer.y, outer.x) * (180 / pi));
}

/// How far, in radians, the view must be turned with the clock so that the fold lines ascend from the first.
double Sketch::turn_of_folds(const glm::dvec2& axis) const {
  try {
    const int count = count_folds();
    if (count == 0) return 0;
    const double first = fold_degrees(1, axis);
    if (first > 359) return radians(first);  // meant to be 0
    for (int fold = 2; fold <= count; ++fold) {
      if (fold_degrees(fold, axis) < first) return radians(first);
    }
  } catch (const BadSketch&) {
    return 0;  // the fault is reported when the angles are read
  }
  return 0;
}

std::vector<double> Sketch::fold_angles(int folds) const {
  // A gap in the numbers means that a line is missing.
  const int count = count_folds();
  const auto& named = view_of(SketchView::top).named;
  for (int later = count + 2; later <= 64; ++later) {
    if (!named.contains(plain_name(fold_name(later)))) continue;
    throw BadSketch(quoted_name(fold_name(count + 1)) + " is missing in the top view of " + drawing_.file +
                        ", though " + quoted_name(fold_name(later)) + " is there",
                    "draw it from the axis outwards, or number the fold lines anew, against the clock");
  }

  // There are no fold lines, or one for each fold.
  if (count == 0) return {};
  if (count != folds) {
    throw BadSketch("has fold lines numbered 1 to " + std::to_string(count) + " in " + drawing_.file +
                        ", but the fruit has " + std::to_string(folds) + " folds",
                    "draw one line for each fold, from the axis outwards, numbered against the clock");
  }

  // Each line must lie beyond the one before, and none beyond the first again.
  const glm::dvec2 axis = top_axis();
  const double turn = turn_of_folds(axis) * (180 / pi);
  std::vector<double> angles;
  double before = -1;
  for (int fold = 1; fold <= folds; ++fold) {
    const double degrees = snapped(fold_degrees(fold, axis) - turn);
    const bool is_first_again = fold > 1 && degrees > angles.front() * (180 / pi) + 360 - min_width;
    if (degrees < before + min_width || is_first_again) {
      throw BadSketch(called(shape_of(SketchView::top, fold_name(fold))) + " does not follow the fold line before it",
                      "number the fold lines against the clock, as seen from above");
    }
    before = degrees;
    angles.push_back(radians(degrees));
  }
  return angles;
}

}  // namespace pomona
