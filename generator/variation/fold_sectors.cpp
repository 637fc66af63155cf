#include "generator/variation/fold_sectors.h"

#include <algorithm>
#include <cmath>

#include "generator/base/units.h"
#include "generator/variation/fold_samples.h"

namespace pomona {

Sectors sectors_between_folds(const FoldSymmetry& symmetry) {
  const std::vector<double> widths = fold_widths(symmetry);
  Sectors sectors;
  for (std::size_t k = 0; k < widths.size(); ++k)
    sectors.push_back({symmetry.fold_angles[k] + 0.5 * widths[k], 0.5 * widths[k]});
  return sectors;
}

double depth_at(const Sectors& sectors, double azimuth) {
  constexpr double deep_enough = 0.5;
  double deepest = -pi;
  for (const Sector& sector : sectors) {
    const double turn = (azimuth - sector.middle) / (2 * pi);
    const double away = 2 * pi * std::fabs(turn - std::round(turn));
    deepest = std::max(deepest, std::min(sector.half_width - away, deep_enough * sector.half_width));
  }
  return deepest;
}

}  // namespace pomona
