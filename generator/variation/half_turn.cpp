#include "generator/variation/half_turn.h"

#include <algorithm>
#include <cmath>

#include "generator/base/units.h"
#include "generator/variation/fold_sectors.h"

namespace pomona {

namespace {

constexpr int turns = 720;  // candidates over half a turn

/// The sectors of the loops of one surface.
Sectors sectors_of(const FoldSymmetry& symmetry, const std::vector<PolarCurve>& folds) {
  const std::vector<double> widths = fold_widths(symmetry);
  Sectors sectors;
  for (std::size_t k = 0; k < folds.size(); ++k) {
    if (folds[k].size() == 0) continue;
    const auto [min, max] = std::minmax_element(folds[k].azimuth.begin(), folds[k].azimuth.end());
    sectors.push_back({symmetry.fold_angles[k] + widths[k] * 0.5 * (*min + *max), widths[k] * 0.5 * (*max - *min)});
  }
  return sectors;
}

/// A side that misses its sector counts for more than one that lies deep within: nothing else makes up for it.
double worth(double depth) { return depth < 0 ? 8 * depth : depth; }

/// How deep the plane at this azimuth lies in the sectors that it must show, on both sides, or on the better one.
double score_at(const std::vector<Sectors>& surfaces, const std::vector<int>& shown, double azimuth) {
  double score = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    if (shown[s] == 0 || surfaces[s].empty()) continue;
    const double ahead = depth_at(surfaces[s], azimuth), behind = depth_at(surfaces[s], azimuth + pi);
    score += worth(shown[s] == 2 ? std::min(ahead, behind) : std::max(ahead, behind));
  }
  return score;
}

}  // namespace

HalfTurn::HalfTurn(const FoldSymmetry& drawn, const std::vector<FoldSamples>& samples) {
  std::vector<Sectors> surfaces;
  for (const FoldSamples& sample : samples) {
    surfaces.push_back(sample.closed ? sectors_of(drawn, sample.fold) : Sectors{});
    const int ahead = depth_at(surfaces.back(), 0) > 0, behind = depth_at(surfaces.back(), pi) > 0;
    shown_.push_back(ahead + behind);
  }
  // Without chambers, the plane stays between fold lines.
  surfaces.push_back(sectors_between_folds(drawn));
  shown_.push_back(std::count(shown_.begin(), shown_.end(), 2) > 0 ? 0 : 2);
  drawn_score_ = score_at(surfaces, shown_, 0);
}

double HalfTurn::operator()(const FoldSymmetry& variant, const std::vector<std::vector<PolarCurve>>& folds) const {
  std::vector<Sectors> surfaces;
  for (std::size_t s = 0; s + 1 < shown_.size(); ++s)
    surfaces.push_back(shown_[s] > 0 ? sectors_of(variant, folds[s]) : Sectors{});
  surfaces.push_back(sectors_between_folds(variant));
  double best = 0, best_score = score_at(surfaces, shown_, 0);
  if (best_score >= drawn_score_ - 1e-9) return 0;

  // Try turns in ascending size, to either side.
  for (int i = 1; i <= turns / 2; ++i) {
    for (const double azimuth : {pi * i / turns, -pi * i / turns}) {
      const double score = score_at(surfaces, shown_, azimuth);
      if (score > best_score + 1e-9) best = azimuth, best_score = score;
    }
  }
  return -best;
}

}  // namespace pomona
