#include "render/compare/flip_kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "generator/base/reproducible.h"

namespace pomona {

namespace {

constexpr double pi = std::numbers::pi;

/// A term of the contrast sensitivity, a sqrt(pi / b) exp(-pi^2 x^2 / b) with x in degrees (table 1 of the paper).
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity light{1, 0.0047}, red_green{1, 0.0053};
constexpr Sensitivity blue_yellow_wide{34.1, 0.04}, blue_yellow_narrow{13.5, 0.025};

/// exp(-pi^2 x^2 / b) at every pixel within the radius.
Kernel bell(double b, int radius, double pixels_per_degree) {
  Kernel kernel;
  for (int i = -radius; i <= radius; ++i) {
    const double degrees = i / pixels_per_degree;
    kernel.push_back(reproducible::exp(-pi * pi * degrees * degrees / b));
  }
  return kernel;
}

double sum(const Kernel& kernel) { return std::accumulate(kernel.begin(), kernel.end(), 0.0); }

Kernel scaled(Kernel kernel, double factor) {
  for (double& weight : kernel) weight *= factor;
  return kernel;
}

/// Positive weights made to sum to 1, negative ones to -1.
Kernel balanced(Kernel kernel) {
  double positive = 0, negative = 0;
  for (const double weight : kernel) (weight > 0 ? positive : negative) += std::fabs(weight);
  for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
  return kernel;
}

}  // namespace

ContrastKernels contrast_kernels(double pixels_per_degree) {
  // Three standard deviations of the widest term.
  const double deviation = std::sqrt(blue_yellow_wide.b / (2 * pi * pi));
  const int radius = static_cast<int>(std::ceil(3 * deviation * pixels_per_degree));
  const auto normalised = [&](Sensitivity term) {
    const Kernel kernel = bell(term.b, radius, pixels_per_degree);
    return scaled(kernel, 1 / sum(kernel));
  };

  // Two terms share one sum: over the picture, a term's weights add up to the square of its factor's.
  const auto amplitude = [](Sensitivity term) { return term.a * std::sqrt(pi / term.b); };
  const Kernel wide = bell(blue_yellow_wide.b, radius, pixels_per_degree);
  const Kernel narrow = bell(blue_yellow_narrow.b, radius, pixels_per_degree);
  const double all =
      amplitude(blue_yellow_wide) * sum(wide) * sum(wide) + amplitude(blue_yellow_narrow) * sum(narrow) * sum(narrow);
  return {.radius = radius,
          .light = normalised(light),
          .red_green = normalised(red_green),
          .blue_yellow_wide = scaled(wide, std::sqrt(amplitude(blue_yellow_wide) / all)),
          .blue_yellow_narrow = scaled(narrow, std::sqrt(amplitude(blue_yellow_narrow) / all))};
}

FeatureKernels feature_kernels(double pixels_per_degree) {
  // An edge is 0.082 degrees wide.
  const double deviation = 0.5 * 0.082 * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * deviation));
  FeatureKernels kernels{.radius = radius, .smooth = {}, .edge = {}, .point = {}};
  for (int x = -radius; x <= radius; ++x) {
    const double steps = x / deviation, weight = reproducible::exp(-steps * steps / 2);
    kernels.smooth.push_back(weight);
    kernels.edge.push_back(-x * weight);
    kernels.point.push_back((steps * steps - 1) * weight);
  }
  kernels.smooth = scaled(kernels.smooth, 1 / sum(kernels.smooth));
  kernels.edge = balanced(kernels.edge);
  kernels.point = balanced(kernels.point);
  return kernels;
}

}  // namespace pomona
