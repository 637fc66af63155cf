#include "generator/variation/vary_loops.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/variation/layers.h"
#include "generator/variation/polar_curve.h"
#include "generator/variation/texture_synthesis.h"

namespace pomona {

namespace {

/// Points per loop while it is varied; finer details of the drawing are smoothed.
constexpr int loop_points = 256;

/// The sample of the synthesis: radius, and angular difference to the next point, of all loops. Star-shaped loops share
/// their azimuths and so their angular differences; others have their own.
struct LoopBundle {
  double start = 0;                      ///< azimuth of the first point
  std::vector<CyclicSignal> log_radius;  ///< one per loop
  std::vector<CyclicSignal> step;        ///< one for all loops, or one per loop
  bool star_shaped = true;
};

double mean(const CyclicSignal& signal) {
  return std::accumulate(signal.begin(), signal.end(), 0.0) / static_cast<double>(signal.size());
}

/// Azimuths of the points, the first at `start`.
std::vector<double> azimuths(double start, const CyclicSignal& step) {
  std::vector<double> result{start};
  for (std::size_t i = 0; i + 1 < step.size(); ++i) result.push_back(result.back() + step[i]);
  return result;
}

/// Angular differences of a closed curve's points.
CyclicSignal steps_of(const PolarCurve& loop) {
  CyclicSignal step;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i) step.push_back(loop.azimuth[i + 1] - loop.azimuth[i]);
  step.push_back(loop.azimuth.front() + 2 * pi - loop.azimuth.back());
  return step;
}

CyclicSignal log_of(const std::vector<double>& radii) {
  CyclicSignal result;
  for (const double r : radii) result.push_back(reproducible::log(r));
  return result;
}

/// The loop from its outermost point at an azimuth, with points at equal distances.
PolarCurve evenly_from(const Curve& loop, double azimuth) {
  const RayHit start = outermost_hit(loop, azimuth);
  Curve turned{walk(loop, start, start), true};
  turned.points.pop_back();
  return to_polar(resampled(turned, loop_points).points);
}

LoopBundle bundle_of(const std::vector<Curve>& loops) {
  LoopBundle bundle;
  const glm::dvec2 first = loops.front().points.front();
  bundle.start = reproducible::atan2(first.y, first.x);
  bundle.star_shaped = std::all_of(loops.begin(), loops.end(), is_star_shaped);

  // The first loop, the outermost, gives the azimuths at which the others are sampled.
  if (bundle.star_shaped) {
    const PolarCurve outermost = evenly_from(loops.front(), bundle.start);
    bundle.step.push_back(steps_of(outermost));
    for (const Curve& loop : loops) {
      bundle.log_radius.push_back(log_of(swells(loop, 1, azimuths(bundle.start, bundle.step.front()))));
    }
    return bundle;
  }
  for (const Curve& loop : loops) {
    const PolarCurve even = evenly_from(loop, bundle.start);
    bundle.step.push_back(steps_of(even));
    bundle.log_radius.push_back(log_of(even.radius));
  }
  return bundle;
}

/// Makes the angular differences add up to one turn. Those of a star-shaped loop stay positive: with positive radii and
/// differences a loop that goes around once is star-shaped, hence simple.
CyclicSignal closed_up(CyclicSignal step, bool star_shaped) {
  const auto n = static_cast<double>(step.size());
  if (star_shaped) {
    for (double& s : step) s = std::max(s, 0.05 * 2 * pi / n);
    const double scale = 2 * pi / std::accumulate(step.begin(), step.end(), 0.0);
    for (double& s : step) s *= scale;
  } else {
    const double missing = (2 * pi - std::accumulate(step.begin(), step.end(), 0.0)) / n;
    for (double& s : step) s += missing;
  }
  return step;
}

LoopBundle copied(const LoopBundle& drawn, const SourceMap& map) {
  LoopBundle variant = drawn;
  for (CyclicSignal& channel : variant.log_radius) channel = copied(channel, map);
  for (CyclicSignal& channel : variant.step) channel = closed_up(copied(channel, map), drawn.star_shaped);
  return variant;
}

CyclicSignal blended(const CyclicSignal& a, const CyclicSignal& b, double share) {
  CyclicSignal result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] + share * (b[i] - a[i]);
  return result;
}

/// The mean shape and the mean angular difference of the loops. Only these are compared as parent structures: with more
/// channels fewer places would be similar, in the end none.
std::vector<CyclicSignal> common_channels(const LoopBundle& bundle) {
  const auto mean_of = [](const std::vector<CyclicSignal>& channels) {
    CyclicSignal sum(channels.front().size(), 0.0);
    for (const CyclicSignal& channel : channels) {
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += channel[i] / static_cast<double>(channels.size());
    }
    return sum;
  };
  return {mean_of(bundle.log_radius), mean_of(bundle.step)};
}

/// A mixture of the rotated drawing and the full synthesis, so that a variant follows its amount continuously. Beyond 1
/// the deviations from the mean radius grow instead: a higher threshold would only break the bands' phase.
LoopBundle synthesised(const LoopBundle& drawn, VariantKey key, double amount) {
  const std::vector<CyclicSignal> common = common_channels(drawn);
  const LoopBundle turned = copied(drawn, draw_source_map(common, key, {.threshold = 0, .mix_turns = false}));
  LoopBundle variant = copied(drawn, draw_source_map(common, key, {}));
  variant.start += 2 * pi * RandomStream(key, "vary/loop/turn").uniform(0);
  const double share = std::min(amount, 1.0), gain = 1 + 0.5 * std::max(amount - 1, 0.0);
  for (std::size_t i = 0; i < variant.log_radius.size(); ++i) {
    CyclicSignal& channel = variant.log_radius[i];
    channel = blended(turned.log_radius[i], channel, share);
    channel = blended(CyclicSignal(channel.size(), mean(channel)), channel, gain);
  }
  for (std::size_t i = 0; i < variant.step.size(); ++i) {
    variant.step[i] = blended(turned.step[i], variant.step[i], share);
  }
  return variant;
}

Curve loop_of(const LoopBundle& bundle, std::size_t index) {
  PolarCurve curve;
  curve.azimuth = azimuths(bundle.start, bundle.step[bundle.star_shaped ? 0 : index]);
  for (const double value : bundle.log_radius[index]) curve.radius.push_back(reproducible::exp(value));
  return from_polar(curve, true);
}

/// For each layer, true if it is not synthesised: it does not vary or does not go around the axis.
std::vector<bool> fixed_layers(const Template& fruit, const Layers& layers) {
  std::vector<bool> fixed;
  for (const std::size_t s : layers.surface) {
    const SurfaceSketch& surface = fruit.surfaces[s];
    fixed.push_back(!surface.varies || !encloses(surface.horizontal.front(), {0, 0}));
  }
  return fixed;
}

/// Loops of the layers that vary: first each layer's own, outermost first, then what stops of the same layers come
/// after.
std::vector<Curve> varied_loops(const Template& fruit, const Layers& layers, const std::vector<bool>& fixed) {
  std::vector<Curve> loops, stops;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i]) continue;
    const std::vector<Curve>& drawn = fruit.surfaces[layers.surface[i]].horizontal;
    loops.push_back(counter_clockwise(drawn.front()));
    for (std::size_t k = 1; k < drawn.size(); ++k) stops.push_back(counter_clockwise(drawn[k]));
  }
  loops.insert(loops.end(), stops.begin(), stops.end());
  return loops;
}

/// Draws layers apart that would cross, each with all its stops. Only for loops that share their azimuths.
void keep_apart(LoopBundle& bundle, const Template& fruit, const Layers& layers, const std::vector<bool>& fixed) {
  // Take the swells of all layers.
  const std::vector<double> at = azimuths(bundle.start, bundle.step.front());
  std::vector<std::vector<double>> all;
  std::size_t next = 0;
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    const SurfaceSketch& surface = fruit.surfaces[layers.surface[i]];
    const double reference = reference_radii(surface).outer;
    if (fixed[i]) {
      all.push_back(swells(surface.horizontal.front(), reference, at));
      continue;
    }
    all.emplace_back();
    for (const double value : bundle.log_radius[next]) all.back().push_back(reproducible::exp(value) / reference);
    ++next;
  }

  // Put those of the varied layers back.
  all = kept_apart(layers, std::move(all), fixed);
  next = 0;
  auto stop = static_cast<std::size_t>(std::count(fixed.begin(), fixed.end(), false));
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i]) continue;
    const SurfaceSketch& surface = fruit.surfaces[layers.surface[i]];
    const double reference = reference_radii(surface).outer;
    for (double& value : all[i]) value *= reference;
    const CyclicSignal before = std::exchange(bundle.log_radius[next], log_of(all[i]));
    for (std::size_t k = 1; k < surface.horizontal.size(); ++k, ++stop) {
      for (std::size_t j = 0; j < before.size(); ++j)
        bundle.log_radius[stop][j] += bundle.log_radius[next][j] - before[j];
    }
    ++next;
  }
}

Template with_loops(const Template& fruit, const Layers& layers, const std::vector<bool>& fixed,
                    const LoopBundle& bundle) {
  Template variant = fruit;
  std::size_t next = 0;
  auto stop = static_cast<std::size_t>(std::count(fixed.begin(), fixed.end(), false));
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    if (fixed[i]) continue;
    SurfaceSketch& surface = variant.surfaces[layers.surface[i]];
    surface.reference = reference_radii(surface);
    surface.horizontal.front() = loop_of(bundle, next++);
    for (std::size_t k = 1; k < surface.horizontal.size(); ++k) surface.horizontal[k] = loop_of(bundle, stop++);
  }
  return variant;
}

/// True if every loop is simple and no two layers cross.
bool is_sound(const Template& variant, const Layers& layers) {
  std::vector<double> at;
  for (int i = 0; i < loop_points; ++i) at.push_back(2 * pi * i / loop_points);
  std::vector<std::vector<double>> all;
  for (const std::size_t s : layers.surface) {
    const SurfaceSketch& surface = variant.surfaces[s];
    if (!std::all_of(surface.horizontal.begin(), surface.horizontal.end(), is_simple)) return false;
    all.push_back(swells(surface.horizontal.front(), reference_radii(surface).outer, at));
  }
  return are_apart(layers, all);
}

}  // namespace

struct LoopVariation::Prepared {
  Template fruit;
  Layers layers;
  std::vector<bool> fixed;  ///< which layers are not synthesised
  SweptCheck swept;
  std::optional<LoopBundle> drawn;  ///< nothing if no loop varies

  Prepared(const Template& drawing, SweptCheck check)
      : fruit(drawing), layers(layers_of(fruit)), fixed(fixed_layers(fruit, layers)), swept(std::move(check)) {
    const std::vector<Curve> loops = varied_loops(fruit, layers, fixed);
    if (!loops.empty()) drawn = bundle_of(loops);
  }

  Template synthesis(VariantKey key, double amount) const {
    LoopBundle variant = synthesised(*drawn, key, amount);
    if (drawn->star_shaped) keep_apart(variant, fruit, layers, fixed);
    return with_loops(fruit, layers, fixed, variant);
  }
};

LoopVariation::LoopVariation(const Template& fruit, SweptCheck swept)
    : prepared_(std::make_shared<Prepared>(fruit, std::move(swept))) {}

Template LoopVariation::draw(VariantKey key, double amount) const {
  const Prepared& p = *prepared_;
  if (!p.drawn) return p.fruit;

  // Star-shaped loops are moved apart. Others may cross themselves or each other, and surfaces may cross by a facet's
  // width though their curves do not: then the variant stays nearer to the drawing.
  for (int attempt = 0; attempt < 8; ++attempt, amount *= 0.7) {
    Template variant = p.synthesis(key, amount);
    const bool simple = p.drawn->star_shaped || is_sound(variant, p.layers);
    if (simple && p.swept.new_crossings(variant).empty()) return variant;
  }
  return p.synthesis(key, 0);
}

}  // namespace pomona
