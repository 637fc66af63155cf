#include "generator/knife/turned_wedges.h"

#include <algorithm>
#include <variant>

#include "generator/base/units.h"
#include "generator/variation/fold_sectors.h"
#include "generator/variation/polar_curve.h"

namespace pomona {

namespace {

constexpr double near_wall = radians(2);
constexpr int steps = 180;  // candidates to either side

double width_of(const Sectors& sectors) {
  double width = 0;
  for (const Sector& sector : sectors) width += 2 * sector.half_width;
  return width;
}

Sectors sectors_of(const SurfaceSketch& surface) {
  Sectors sectors;
  for (const Curve& loop : surface.horizontal) {
    if (loop.points.empty()) continue;
    const PolarCurve polar = to_polar(loop.points);
    const auto [min, max] = std::minmax_element(polar.azimuth.begin(), polar.azimuth.end());
    sectors.push_back({0.5 * (*min + *max), 0.5 * (*max - *min)});
  }
  return sectors;
}

/// The sectors of the main chamber, or of the folds.
Sectors main_sectors(const Template& fruit, const FoldSymmetry& symmetry) {
  Sectors main;
  for (const SurfaceSketch& surface : fruit.surfaces) {
    if (surface.type != SurfaceType::in_fold || surface.front.part == surface.back.part) continue;
    Sectors own = sectors_of(surface);
    if (width_of(own) > width_of(main)) main = std::move(own);
  }
  return main.empty() ? sectors_between_folds(symmetry) : main;
}

double least_depth(const Sectors& sectors, double start, int count) {
  double least = pi;
  for (int i = 0; i < count; ++i) least = std::min(least, depth_at(sectors, start + 2 * pi * i / count));
  return least;
}

}  // namespace

double wedge_start(const Template& variant, int count) {
  const auto* symmetry = std::get_if<FoldSymmetry>(&variant.symmetry);
  if (!symmetry) return 0;
  const Sectors sectors = main_sectors(variant, *symmetry);
  double best = 0, most = least_depth(sectors, 0, count);
  if (most >= near_wall) return 0;
  for (int i = 1; i <= steps; ++i) {
    for (const double start : {pi * i / (count * steps), -pi * i / (count * steps)}) {
      const double depth = least_depth(sectors, start, count);
      if (depth > most + 1e-9) best = start, most = depth;
    }
  }
  return best;
}

std::vector<Knife> turned_wedges(std::span<const Knife> knives, const Template& variant) {
  std::vector<Knife> turned(knives.begin(), knives.end());
  for (Knife& knife : turned) {
    auto* cut = std::get_if<PlaneCut>(&knife.cut);
    auto* wedges = cut ? std::get_if<WedgeKnife>(cut) : nullptr;
    if (wedges) wedges->start = wedge_start(variant, wedges->count);
  }
  return turned;
}

}  // namespace pomona
