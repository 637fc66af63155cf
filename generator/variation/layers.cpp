#include "generator/variation/layers.h"

#include <algorithm>

namespace pomona {

namespace {

/// What layer i may be at one azimuth, given those already placed.
SwellRange room(const Layers& layers, const std::vector<std::vector<double>>& swells,
                const std::vector<std::size_t>& placed, std::size_t i, std::size_t azimuth) {
  SwellRange range;
  for (const std::size_t j : placed) {
    const SwellRange here = layers.gap[i][j].room(swells[j][azimuth]);
    range.low = std::max(range.low, here.low);
    range.high = std::min(range.high, here.high);
  }
  if (range.low > range.high) range.low = range.high = 0.5 * (range.low + range.high);
  return range;
}

/// How far to go from `start`, which lies in the range, towards `end`: 1 = all the way.
double share_within(const SwellRange& range, double start, double end) {
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
  const std::size_t n = layers.surface.size();
  layers.gap.assign(n, std::vector<LayerGap>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      layers.gap[i][j] = LayerGap(fruit.surfaces[layers.surface[i]], fruit.surfaces[layers.surface[j]]);
      layers.gap[j][i] = layers.gap[i][j].inverted();
    }
  }
  return layers;
}

std::vector<std::vector<double>> kept_apart(const Layers& layers, std::vector<std::vector<double>> swells,
                                            const std::vector<bool>& fixed) {
  std::vector<std::size_t> placed;
  for (std::size_t i = 0; i < swells.size(); ++i) {
    if (fixed[i]) placed.push_back(i);
  }
  std::size_t outside = swells.size();  // the next layer outside that moves; none at first
  for (std::size_t i = 0; i < swells.size(); ++i) {
    if (fixed[i]) continue;
    // Start from the swell of the layer outside, or from a circle, and go as far as there is room.
    std::vector<double>& swell = swells[i];
    std::vector<double> start(swell.size()), share(swell.size());
    for (std::size_t a = 0; a < swell.size(); ++a) {
      const SwellRange range = room(layers, swells, placed, i, a);
      const double other = outside < swells.size() ? swells[outside][a] : 1;
      start[a] = std::clamp(other, range.low, range.high);
      share[a] = share_within(range, start[a], swell[a]);
    }
    share = smoothed_below(share);
    for (std::size_t a = 0; a < swell.size(); ++a) swell[a] = start[a] + share[a] * (swell[a] - start[a]);
    placed.push_back(i);
    outside = i;
  }
  return swells;
}

bool are_apart(const Layers& layers, const std::vector<std::vector<double>>& swells) {
  constexpr double rounding = 1e-3;  // resampling changes the drawing itself by as much
  for (std::size_t i = 0; i < swells.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t a = 0; a < swells[i].size(); ++a) {
        const SwellRange range = layers.gap[i][j].room(swells[j][a]);
        if (swells[i][a] < range.low - rounding || swells[i][a] > range.high + rounding) return false;
      }
    }
  }
  return true;
}

}  // namespace pomona
