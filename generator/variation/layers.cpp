#include "generator/variation/layers.h"

#include <algorithm>
#include <numeric>

#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr std::size_t compared_azimuths = 360;

std::vector<double> even_azimuths(std::size_t count) {
  std::vector<double> azimuths(count);
  for (std::size_t i = 0; i < count; ++i) azimuths[i] = 2 * pi * static_cast<double>(i) / static_cast<double>(count);
  return azimuths;
}

/// What layer i may be at one azimuth, given those already placed.
LogRange room(const Layers& layers, const std::vector<std::vector<double>>& shapes,
              const std::vector<std::size_t>& placed, std::size_t i, std::size_t azimuth) {
  constexpr double far = 1e9;
  LogRange range{-far, far};
  for (const std::size_t j : placed) {
    range.low = std::max(range.low, shapes[j][azimuth] + layers.allowed[i][j].low);
    range.high = std::min(range.high, shapes[j][azimuth] + layers.allowed[i][j].high);
  }
  if (range.low > range.high) range.low = range.high = 0.5 * (range.low + range.high);
  return range;
}

/// How far to go from `start`, which lies in the range, towards `end`: 1 = all the way.
double share_within(const LogRange& range, double start, double end) {
  if (end > range.high) return (range.high - start) / (end - start);
  if (end < range.low) return (range.low - start) / (end - start);
  return 1;
}

/// The least value around each place, then its average around each place: nowhere more than the value itself.
std::vector<double> smoothed_below(const std::vector<double>& values) {
  constexpr std::size_t reach = 6;  // of 256: about 8 degrees to either side
  const std::size_t n = values.size();
  std::vector<double> least(n), mean(n);
  for (std::size_t i = 0; i < n; ++i) {
    least[i] = values[i];
    for (std::size_t d = 0; d <= 2 * reach; ++d) least[i] = std::min(least[i], values[(i + n + d - reach) % n]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d <= 2 * reach; ++d) mean[i] += least[(i + n + d - reach) % n];
    mean[i] = std::min(values[i], mean[i] / static_cast<double>(2 * reach + 1));
  }
  return mean;
}

}  // namespace

Layers layers_of(const Template& fruit) {
  // Order them from the outside inwards.
  Layers layers;
  for (std::size_t s = 0; s < fruit.surfaces.size(); ++s) {
    const SurfaceSketch& surface = fruit.surfaces[s];
    if (surface.type == SurfaceType::around_axis && !surface.horizontal.empty()) layers.surface.push_back(s);
  }
  const auto area = [&](std::size_t s) { return area_to_axis(fruit.surfaces[s].vertical); };
  std::stable_sort(layers.surface.begin(), layers.surface.end(),
                   [&](std::size_t a, std::size_t b) { return area(a) > area(b); });

  // Compare every two of them.
  const std::vector<double> azimuths = even_azimuths(compared_azimuths);
  std::vector<std::vector<double>> drawn;
  for (const std::size_t s : layers.surface) {
    const SurfaceSketch& surface = fruit.surfaces[s];
    drawn.push_back(log_shape(surface.horizontal.front(), reference_radii(surface).outer, azimuths));
  }
  const std::size_t n = layers.surface.size();
  layers.allowed.assign(n, std::vector<LogRange>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const LogRange range =
          allowed_log_ratio(fruit.surfaces[layers.surface[i]], fruit.surfaces[layers.surface[j]], drawn[i], drawn[j]);
      layers.allowed[i][j] = range;
      layers.allowed[j][i] = {-range.high, -range.low};
    }
  }
  return layers;
}

std::vector<std::vector<double>> kept_apart(const Layers& layers, std::vector<std::vector<double>> shapes,
                                            const std::vector<bool>& fixed) {
  std::vector<std::size_t> placed;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (fixed[i]) placed.push_back(i);
  }
  std::size_t outside = shapes.size();  // the next layer outside that moves; none at first
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (fixed[i]) continue;
    // Start from the shape of the layer outside, or from a circle, and go as far as there is room.
    std::vector<double>& shape = shapes[i];
    std::vector<double> start(shape.size()), share(shape.size());
    for (std::size_t a = 0; a < shape.size(); ++a) {
      const LogRange range = room(layers, shapes, placed, i, a);
      const double other = outside < shapes.size() ? shapes[outside][a] : 0;
      start[a] = std::clamp(other, range.low, range.high);
      share[a] = share_within(range, start[a], shape[a]);
    }
    share = smoothed_below(share);
    for (std::size_t a = 0; a < shape.size(); ++a) shape[a] = start[a] + share[a] * (shape[a] - start[a]);
    placed.push_back(i);
    outside = i;
  }
  return shapes;
}

}  // namespace pomona
