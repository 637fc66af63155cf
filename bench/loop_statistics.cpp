#include "bench/loop_statistics.h"

#include <algorithm>
#include <cmath>

#include "generator/base/parallel.h"
#include "generator/base/units.h"
#include "generator/variation/polar_curve.h"

namespace pomona::bench {

namespace {

constexpr int rays = 256;
constexpr std::array<int, 4> band_starts = {1, 4, 16, 64};

/// One loop: mean of the logarithm of its radius, and its power by bands. Variance is the power of all harmonics.
struct LoopShape {
  double mean = 0, variance = 0;
  std::array<double, 3> power{};
};

/// (cos, sin) of every whole part of a turn.
std::vector<glm::dvec2> turn() {
  std::vector<glm::dvec2> points;
  for (int i = 0; i < rays; ++i) points.push_back(polar_point(2 * pi * i / rays, 1));
  return points;
}

LoopShape shape_of(const Curve& loop) {
  const RadiusOf radius_of(loop);
  std::vector<double> value;
  LoopShape shape;
  for (int i = 0; i < rays; ++i) {
    value.push_back(std::log(radius_of(2 * pi * i / rays)));
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

/// All loops that a cylindrical template's variants synthesise.
std::vector<LoopShape> shapes_of(const Template& fruit) {
  std::vector<LoopShape> shapes;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    if (surface.type != SurfaceType::around_axis || !surface.varies || surface.horizontal.empty()) continue;
    if (encloses(surface.horizontal.front(), {0, 0})) shapes.push_back(shape_of(surface.horizontal.front()));
  }
  return shapes;
}

double total_variance(const std::vector<LoopShape>& shapes) {
  double total = 0;
  for (const LoopShape& shape : shapes) total += shape.variance;
  return total;
}

}  // namespace

LoopStatistics loop_statistics(const Template& fruit, const VariantSettings& settings) {
  const std::vector<LoopShape> drawn = shapes_of(fruit);
  std::vector<std::vector<LoopShape>> variants(static_cast<std::size_t>(settings.count));
  parallel_for(variants.size(), {}, [&](std::size_t v) {
    variants[v] = shapes_of(vary(fruit, {v + 1, 0}, settings.how));
  });

  LoopStatistics result;
  result.least_deviation = 1e9;
  const double n = settings.count, drawn_variance = total_variance(drawn);
  std::vector<double> mean(drawn.size(), 0.0);
  for (const LoopShape& shape : drawn) {
    for (std::size_t b = 0; b < shape.power.size(); ++b) result.drawn_power[b] += shape.power[b] / drawn_variance;
  }
  double variance = 0;
  for (const std::vector<LoopShape>& variant : variants) {
    const double here = total_variance(variant);
    variance += here / n;
    result.least_deviation = std::min(result.least_deviation, std::sqrt(here / drawn_variance));
    result.most_deviation = std::max(result.most_deviation, std::sqrt(here / drawn_variance));
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
