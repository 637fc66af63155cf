#include "tests/surface/sketches.h"

#include <utility>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"

namespace pomona::sketches {

Curve loop(const std::function<double(double)>& radius, int points) {
  Curve curve;
  curve.closed = true;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * pi * i / points;
    curve.points.push_back(radius(angle) * glm::dvec2(reproducible::cos(angle), reproducible::sin(angle)));
  }
  return curve;
}

Curve circle(double radius) {
  return loop([=](double) { return radius; });
}

Curve circle_at(const glm::dvec2& center, double radius, int points) {
  Curve curve = loop([=](double) { return radius; }, points);
  for (glm::dvec2& p : curve.points) p += center;
  return curve;
}

Curve meridian(double radius) {
  Curve curve;
  for (int i = 0; i <= 360; ++i) {
    const double angle = pi * i / 360;
    curve.points.emplace_back(radius * reproducible::sin(angle), radius * (1 - reproducible::cos(angle)));
  }
  curve.points.front().x = curve.points.back().x = 0;
  return curve;
}

SurfaceSketch around_axis(Curve vertical, Curve horizontal) {
  SurfaceSketch sketch;
  sketch.name = "skin";
  sketch.vertical = std::move(vertical);
  sketch.horizontal = {std::move(horizontal)};
  sketch.front = {0, {Ramp<Color>::constant(Color(0.8f, 0.2f, 0.1f))}, true};
  sketch.back = {1, {Ramp<Color>::constant(Color(0.9f, 0.8f, 0.6f))}, false};
  return sketch;
}

SurfaceSketch in_fold(Curve vertical, std::vector<Curve> horizontal) {
  SurfaceSketch sketch;
  sketch.name = "chamber";
  sketch.type = SurfaceType::in_fold;
  sketch.vertical = std::move(vertical);
  sketch.horizontal = std::move(horizontal);
  sketch.front = {1, {Ramp<Color>::constant(Color(0.9f, 0.8f, 0.6f))}, false};
  sketch.back = {1, {Ramp<Color>::constant(Color(0.6f, 0.7f, 0.2f))}, false};
  sketch.around = 48;
  sketch.along = 24;
  return sketch;
}

Template fruit(std::vector<SurfaceSketch> surfaces, int folds) {
  Template made;
  made.name = "test fruit";
  made.parts = {"skin", "flesh"};
  made.surfaces = std::move(surfaces);
  if (folds > 0) {
    FoldSymmetry symmetry;
    for (int k = 0; k < folds; ++k) symmetry.fold_angles.push_back(2 * pi * k / folds);
    made.symmetry = symmetry;
  }
  return made;
}

}  // namespace pomona::sketches
