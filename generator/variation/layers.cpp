#include "generator/variation/layers.h"

#include <algorithm>
#include <cmath>

#include "generator/base/cross.h"
#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "generator/surface/sweep/profile.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

namespace {

/// The share of a gap, in logarithms, that variants use; the rest is for the facets of the sweep.
constexpr double used_share = 0.8;

constexpr int compared_azimuths = 180;

/// True if the inner points of two segments meet at one point.
bool cross_properly(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  if (std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y)) return false;
  const double abc = cross(b - a, c - a), abd = cross(b - a, d - a);
  const double cda = cross(d - c, a - c), cdb = cross(d - c, b - c);
  return abc * abd < 0 && cda * cdb < 0;
}

bool cross_as_drawn(const Profile& a, const Profile& b) {
  for (std::size_t i = 0; i + 1 < a.points.size(); ++i) {
    for (std::size_t j = 0; j + 1 < b.points.size(); ++j) {
      if (cross_properly(a.points[i], a.points[i + 1], b.points[j], b.points[j + 1])) return true;
    }
  }
  return false;
}

double farthest(const Profile& profile) {
  double max = 0;
  for (const glm::dvec2& p : profile.points) max = std::max(max, p.x);
  return max;
}

/// Calls body(radius, share of the length) for every point of the profile at this height.
template <typename Body>
void for_places_at(const Profile& profile, double height, const Body& body) {
  for (std::size_t e = 0; e + 1 < profile.points.size(); ++e) {
    const glm::dvec2& a = profile.points[e];
    const glm::dvec2& b = profile.points[e + 1];
    if (height < std::min(a.y, b.y) || height > std::max(a.y, b.y)) continue;
    const double way = a.y == b.y ? 0 : (height - a.y) / (b.y - a.y);
    body(a.x + (b.x - a.x) * way, profile.share[e] + (profile.share[e + 1] - profile.share[e]) * way);
    if (a.y == b.y) body(b.x, profile.share[e + 1]);
  }
}

/// The swell where only a share of it applies.
double shown(double swell, double share) { return 1 + (swell - 1) * share; }

std::vector<double> swells_around(const SurfaceSketch& sketch) {
  std::vector<double> azimuths;
  for (int i = 0; i < compared_azimuths; ++i) azimuths.push_back(2 * pi * i / compared_azimuths);
  return swells(sketch.horizontal.front(), reference_radii(sketch).outer, azimuths);
}

}  // namespace

std::vector<double> swells(const Curve& loop, double reference, const std::vector<double>& azimuths) {
  const RadiusOf radius_of(loop);
  std::vector<double> result;
  for (const double azimuth : azimuths) {
    const double radius = radius_of(azimuth);
    result.push_back(radius > 0 && reference > 0 ? radius / reference : 1);
  }
  return result;
}

LayerGap::LayerGap(const SurfaceSketch& a, const SurfaceSketch& b) {
  const Profile pa = sampled_profile(a.vertical, a.along), pb = sampled_profile(b.vertical, b.along);
  if (cross_as_drawn(pa, pb)) return;

  // Collect every touch. On the axis nothing moves.
  const double axis = 1e-6 * std::max(farthest(pa), farthest(pb));
  const auto touch = [&](double radius_a, double share_a, double radius_b, double share_b) {
    if (radius_a <= axis || radius_b <= axis) return;
    const Touch found{radius_b / radius_a, 1 - a.roundness(share_a), 1 - b.roundness(share_b)};
    if (found.ratio >= 1) above_.push_back(found);
    if (found.ratio <= 1) below_.push_back(found);
  };
  for (std::size_t i = 0; i < pa.points.size(); ++i) {
    const glm::dvec2& p = pa.points[i];
    for_places_at(pb, p.y, [&](double radius, double share) { touch(p.x, pa.share[i], radius, share); });
  }
  for (std::size_t i = 0; i < pb.points.size(); ++i) {
    const glm::dvec2& p = pb.points[i];
    for_places_at(pa, p.y, [&](double radius, double share) { touch(radius, share, p.x, pb.share[i]); });
  }
  leave_margin(a, b);
}

void LayerGap::leave_margin(const SurfaceSketch& a, const SurfaceSketch& b) {
  // Keep only the nearest of touches with equal shares.
  const auto keep_nearest = [](std::vector<Touch>& touches, bool above) {
    std::stable_sort(touches.begin(), touches.end(), [&](const Touch& l, const Touch& r) {
      if (l.share_a != r.share_a) return l.share_a < r.share_a;
      if (l.share_b != r.share_b) return l.share_b < r.share_b;
      return above ? l.ratio < r.ratio : l.ratio > r.ratio;
    });
    const auto same = [](const Touch& l, const Touch& r) { return l.share_a == r.share_a && l.share_b == r.share_b; };
    touches.erase(std::unique(touches.begin(), touches.end(), same), touches.end());
  };
  keep_nearest(above_, true);
  keep_nearest(below_, false);

  // Keep a distance from them, but allow the drawing's own distance.
  const std::vector<double> swells_a = swells_around(a), swells_b = swells_around(b);
  const auto drawn = [&](const Touch& touch, std::size_t i) {
    return shown(swells_a[i], touch.share_a) / shown(swells_b[i], touch.share_b);
  };
  for (Touch& touch : above_) {
    touch.ratio = reproducible::pow(touch.ratio, used_share);
    for (std::size_t i = 0; i < swells_a.size(); ++i) touch.ratio = std::max(touch.ratio, drawn(touch, i));
  }
  for (Touch& touch : below_) {
    touch.ratio = reproducible::pow(touch.ratio, used_share);
    for (std::size_t i = 0; i < swells_a.size(); ++i) touch.ratio = std::min(touch.ratio, drawn(touch, i));
  }
}

SwellRange LayerGap::room(double swell_b) const {
  // Solve shown(swell of a) = ratio * shown(swell of b) at every touch.
  SwellRange range;
  const auto limit = [&](const Touch& touch) {
    return 1 + (touch.ratio * shown(swell_b, touch.share_b) - 1) / touch.share_a;
  };
  for (const Touch& touch : above_) {
    if (touch.share_a > 0) range.high = std::min(range.high, limit(touch));
  }
  for (const Touch& touch : below_) {
    if (touch.share_a > 0) range.low = std::max(range.low, limit(touch));
  }
  return range;
}

LayerGap LayerGap::inverted() const {
  const auto exchanged = [](const std::vector<Touch>& touches) {
    std::vector<Touch> result;
    for (const Touch& t : touches) result.push_back({1 / t.ratio, t.share_b, t.share_a});
    return result;
  };
  LayerGap result;
  result.above_ = exchanged(below_);
  result.below_ = exchanged(above_);
  return result;
}

double area_to_axis(const Curve& vertical) {
  double twice = 0;
  for (std::size_t i = 0; i + 1 < vertical.points.size(); ++i) {
    const glm::dvec2& a = vertical.points[i];
    const glm::dvec2& b = vertical.points[i + 1];
    twice += (a.x + b.x) * (b.y - a.y);
  }
  return 0.5 * std::abs(twice);
}

namespace {

/// The allowed swells of layer i at one azimuth, given the layers that are already placed.
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

/// How far one can go from `start`, which lies in the range, towards `end`: 1 = all the way.
double share_within(const SwellRange& range, double start, double end) {
  if (end > range.high) return (range.high - start) / (end - start);
  if (end < range.low) return (range.low - start) / (end - start);
  return 1;
}

/// The minimum around each place, then its average around each place: nowhere more than the value itself.
std::vector<double> smoothed_below(const std::vector<double>& values) {
  constexpr std::size_t reach = 6;  // of 256: about 8 degrees to either side
  const std::size_t n = values.size();
  std::vector<double> min(n), mean(n);
  for (std::size_t i = 0; i < n; ++i) {
    min[i] = values[i];
    for (std::size_t d = 0; d <= 2 * reach; ++d) min[i] = std::min(min[i], values[(i + n + d - reach) % n]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t d = 0; d <= 2 * reach; ++d) mean[i] += min[(i + n + d - reach) % n];
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

  // Find the gap between every two of them.
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
    // Start from the swell of the next layer outside, or from a circle, and go as far as the range allows.
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
