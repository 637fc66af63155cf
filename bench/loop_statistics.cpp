#include "bench/loop_statistics.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "generator/base/units.h"
#include "generator/variation/polar_curve.h"

namespace pomona::bench {

namespace {

constexpr int rays = 256;
constexpr std::array<int, 4> band_starts = {1, 4, 16, 64};

/// (cos, sin) of every whole part of a turn.
std::vector<glm::dvec2> turn() {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < rays; ++i) points.push_back(polar_point(2 * pi * i / rays, 1));
  return points;
}

LoopShape shape_of(const SurfaceSketch& surface) {
  const RadiusOf radius_of(surface.horizontal.front());
  const double reference = reference_radii(surface).outer;
  std::vector<double> value;
  LoopShape shape;
  for (int i = 0; i < rays; ++i) {
    value.push_back(std::log(radius_of(2 * pi * i / rays) / reference));
    shape.mean += value.back() / rays;
  }
  for (const double v : value) shape.variance += (v - shape.mean) * (v - shape.mean) / rays;

  const std::vector<glm::dvec2> circle = turn();
  for (std::size_t band = 0; band < shape.power.size(); ++band) {
    for (int h = band_starts[band]; h < band_starts[band + 1]; ++h) {
      glm::dvec2 sum(0);
      for (int i = 0; i < rays; ++i) {
        sum += value[static_cast<std::size_t>(i)] * circle[static_cast<std::size_t>(i * h % rays)];
      }
      shape.power[band] += 2 * (sum.x * sum.x + sum.y * sum.y) / (rays * rays);
    }
  }
  return shape;
}

double total_variance(const std::vector<LoopShape>& shapes) {
  double total = 0;
  for (const LoopShape& shape : shapes) total += shape.variance;
  return total;
}

}  // namespace

std::vector<LoopShape> loop_shapes(const Template& fruit) {
  std::vector<LoopShape> shapes;
  if (!std::holds_alternative<CylindricalSymmetry>(fruit.symmetry)) return shapes;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    if (surface.type != SurfaceType::around_axis || !surface.varies || surface.horizontal.empty()) continue;
    if (encloses(surface.horizontal.front(), {0, 0})) shapes.push_back(shape_of(surface));
  }
  if (total_variance(shapes) < 1e-12) shapes.clear();  // circles have no shape that could be synthesised
  return shapes;
}

LoopStatistics loop_statistics(const std::vector<LoopShape>& drawn,
                               const std::vector<std::vector<LoopShape>>& variants) {
  LoopStatistics result;
  result.min_deviation = 1e9;
  const double n = static_cast<double>(variants.size()), drawn_variance = total_variance(drawn);
  std::vector<double> mean(drawn.size(), 0.0);
  for (const LoopShape& shape : drawn) {
    for (std::size_t b = 0; b < shape.power.size(); ++b) result.drawn_power[b] += shape.power[b] / drawn_variance;
  }
  double variance = 0;
  for (const std::vector<LoopShape>& variant : variants) {
    const double here = total_variance(variant);
    variance += here / n;
    result.min_deviation = std::min(result.min_deviation, std::sqrt(here / drawn_variance));
    result.max_deviation = std::max(result.max_deviation, std::sqrt(here / drawn_variance));
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      mean[i] += variant[i].mean / n;
      for (std::size_t b = 0; b < result.power.size(); ++b) {
        result.power[b] += variant[i].power[b] / (n * drawn_variance);
      }
    }
  }
  result.deviation = std::sqrt(variance / drawn_variance);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    result.mean_shift = std::max(result.mean_shift, std::abs(mean[i] - drawn[i].mean));
  }
  return result;
}

}  // namespace pomona::bench
