#include "tests/variation/fruits.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/variation/polar_curve.h"

namespace pomona::fruits {

namespace {

Curve loop(int points, const std::function<double(double)>& radius) {
  Curve curve;
  curve.closed = true;
  for (int i = 0; i < points; ++i) {
    const double azimuth = 2 * pi * i / points;
    curve.points.push_back(polar_point(azimuth, radius(azimuth)));
  }
  return curve;
}

/// Half an ellipse from the bottom to the top of the axis.
Curve half_ellipse(double radius, double half_height, double center) {
  Curve curve;
  for (int i = 0; i <= 48; ++i) {
    const double angle = pi * (i / 48.0 - 0.5);
    const double x = i == 0 || i == 48 ? 0 : radius * reproducible::cos(angle);
    curve.points.push_back({x, center + half_height * reproducible::sin(angle)});
  }
  return curve;
}

/// An ellipse about a centre, closed.
Curve ellipse(const glm::dvec2& center, double a, double b, int points) {
  Curve curve;
  curve.closed = true;
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * pi * i / points;
    curve.points.push_back(center + glm::dvec2(a * reproducible::cos(angle), b * reproducible::sin(angle)));
  }
  return curve;
}

SurfaceSketch around_axis(const std::string& name, Curve vertical, Curve horizontal) {
  SurfaceSketch surface;
  surface.name = name;
  surface.vertical = std::move(vertical);
  surface.horizontal = {std::move(horizontal)};
  surface.around = 40;  // few triangles, because there are many variants
  surface.along = 16;
  surface.front.color.along = surface.back.color.along = Ramp<Color>::constant(Color(0.5f));
  return surface;
}

Template named(const std::string& name) {
  Template fruit;
  fruit.name = fruit.title = fruit.file = name;
  fruit.parts = {"flesh"};
  return fruit;
}

/// 0 at the ends of a fold, 1 in its middle.
double bulge(double share) { return reproducible::sin(pi * share); }

}  // namespace

Template onion(int layers) {
  Template fruit = named("onion");
  for (int i = 0; i < layers; ++i) {
    const double radius = 0.04 * (1 - 0.12 * i);
    const auto wave = [&](double t) {
      return radius * (1 + 0.035 * reproducible::cos(2 * t + 0.4 * i) + 0.02 * reproducible::sin(5 * t + 0.2 * i) +
                       0.01 * reproducible::cos(11 * t) + 0.008 * reproducible::sin(17 * t + 0.3 * i));
    };
    fruit.surfaces.push_back(
        around_axis("layer " + std::to_string(i), half_ellipse(radius, 0.9 * radius, 0.04), loop(200, wave)));
  }
  fruit.surfaces.front().front.hidden = true;
  return fruit;
}

Template curly() {
  Template fruit = named("curly");
  Curve spiral = loop(240, [](double t) { return 0.03 + 0.004 * reproducible::sin(12 * t); });
  for (glm::dvec2& p : spiral.points) {
    const double r = glm::length(p);
    const double azimuth = reproducible::atan2(p.y, p.x);
    p = polar_point(azimuth + 0.22 * reproducible::sin((r - 0.03) / 0.004), r);
  }
  fruit.surfaces.push_back(around_axis("skin", half_ellipse(0.03, 0.03, 0.03), spiral));
  return fruit;
}

Template tomato(int folds) {
  Template fruit = named("tomato");
  // Folds and their lobes differ by a few percent.
  std::vector<double> widths, lines;
  double total = 0;
  for (int k = 0; k < folds; ++k) widths.push_back(1 + 0.12 * reproducible::sin(2.3 * k + 1));
  for (const double w : widths) total += w;
  for (int k = 0; k < folds; ++k) {
    lines.push_back(k == 0 ? 0 : lines.back() + 2 * pi * widths[static_cast<std::size_t>(k) - 1] / total);
  }
  fruit.symmetry = FoldSymmetry{lines};
  lines.push_back(2 * pi);
  const auto lobed = [&](double radius, double depth, double own) {
    return loop(60 * folds, [=](double t) {
      int k = 0;
      while (k + 1 < folds && t >= lines[static_cast<std::size_t>(k) + 1]) ++k;
      const double from = lines[static_cast<std::size_t>(k)], to = lines[static_cast<std::size_t>(k) + 1];
      const double share = (t - from) / (to - from);
      return radius * (1 + bulge(share) * (depth + own * reproducible::sin(1.7 * k + 0.3)) +
                       own * 0.3 * reproducible::sin(2 * pi * share) * reproducible::cos(2.1 * k));
    });
  };
  fruit.surfaces.push_back(around_axis("skin", half_ellipse(0.035, 0.028, 0.028), lobed(0.033, 0.09, 0.04)));
  fruit.surfaces.push_back(around_axis("wall", half_ellipse(0.030, 0.023, 0.028), lobed(0.0285, 0.07, 0.04)));
  fruit.surfaces.push_back(around_axis("core", half_ellipse(0.010, 0.019, 0.028), lobed(0.0095, 0.06, 0.05)));
  fruit.surfaces.front().front.hidden = true;

  // A chamber in each fold, with a slightly different turn in each.
  SurfaceSketch chamber = around_axis("chamber", ellipse({0.0195, 0.028}, 0.0070, 0.012, 64), {});
  chamber.type = SurfaceType::in_fold;
  chamber.horizontal.clear();
  for (int k = 0; k < folds; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double middle = 0.5 * (lines[at] + lines[at + 1]), half = 0.5 * (lines[at + 1] - lines[at]);
    Curve egg = ellipse({0, 0}, 1, 1, 48);
    for (glm::dvec2& p : egg.points) {
      const double r = 0.0195 + p.x * 0.0070 * (1 + 0.05 * reproducible::sin(1.3 * k));
      const double width = std::min(half, 1.0) * (0.62 + 0.06 * reproducible::cos(1.9 * k) + 0.12 * p.x);
      p = polar_point(middle + p.y * width, r);
    }
    const auto first = egg.points.begin() + (7 * k) % 48;
    std::rotate(egg.points.begin(), first, egg.points.end());
    chamber.horizontal.push_back(egg);
  }
  fruit.surfaces.push_back(chamber);
  return fruit;
}

double waviness(const Curve& curve) {
  double min = 1e9, max = 0;
  for (const glm::dvec2& p : curve.points) {
    min = std::min(min, glm::length(p));
    max = std::max(max, glm::length(p));
  }
  return 2 * (max - min) / (max + min);
}

}  // namespace pomona::fruits
