// Small templates made in code, for tests of sweeps and grains.
#pragma once

#include <functional>

#include "generator/template/template.h"

namespace pomona::sketches {

/// A closed loop around the axis, given by its radius as a function of the angle.
Curve loop(const std::function<double(double)>& radius, int points = 720);
Curve circle(double radius);

/// A circle seen from above or from the side.
Curve circle_at(const glm::dvec2& center, double radius, int points = 360);

/// Half a circle from pole to pole: the vertical curve of a sphere whose lowest point is at y = 0.
Curve meridian(double radius);

/// One surface around the axis.
SurfaceSketch around_axis(Curve vertical, Curve horizontal);

/// One surface with a loop in every fold.
SurfaceSketch in_fold(Curve vertical, std::vector<Curve> horizontal);

/// A template with parts "skin" and "flesh"; `folds` of 0 means cylindrical symmetry.
Template fruit(std::vector<SurfaceSketch> surfaces, int folds = 0);

}  // namespace pomona::sketches
