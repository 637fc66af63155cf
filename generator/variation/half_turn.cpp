#include "generator/variation/half_turn.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "generator/base/units.h"

namespace pomona {

namespace {

constexpr int turns = 720;  // candidates over half a turn

/// Adds the sectors of the loops of one surface.
void add_sectors(Sectors& sectors, const FoldSymmetry& symmetry, const std::vector<PolarCurve>& folds) {
  const std::vector<double> widths = fold_widths(symmetry);
  for (std::size_t k = 0; k < folds.size(); ++k) {
    if (folds[k].size() == 0) continue;
    const auto [min, max] = std::minmax_element(folds[k].azimuth.begin(), folds[k].azimuth.end());
    sectors.push_back({symmetry.fold_angles[k] + widths[k] * 0.5 * (*min + *max), widths[k] * 0.5 * (*max - *min)});
  }
}

/// A side that misses its sector counts for more than one that lies deep within: nothing else makes up for it.
double worth(double depth) { return depth < 0 ? 8 * depth : depth; }

/// How deep the plane at this azimuth lies in the sectors, on both sides, or on the better one.
double depth_on(int sides, const Sectors& sectors, double azimuth) {
  const double ahead = depth_at(sectors, azimuth), behind = depth_at(sectors, azimuth + pi);
  return sides == 2 ? std::min(ahead, behind) : std::max(ahead, behind);
}

/// On how many sides of the axis z = 0 passes through one of the sectors.
int sides_shown(const Sectors& sectors) { return (depth_at(sectors, 0) > 0) + (depth_at(sectors, pi) > 0); }

struct Heights {
  double low = 0, high = 0;
};

Heights heights_of(const SurfaceSketch& surface) {
  const std::vector<glm::dvec2>& points = surface.vertical.points;
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  return {low->y, high->y};
}

/// Whether more than half of the shorter one is at heights of the other.
bool are_level(const Heights& a, const Heights& b) {
  return std::min(a.high, b.high) - std::max(a.low, b.low) > 0.5 * std::min(a.high - a.low, b.high - b.low);
}

/// The parts of the grains on a surface.
std::set<int> grains_on(const Template& fruit, std::size_t surface) {
  std::set<int> parts;
  for (const GrainSketch& grain : fruit.grains)
    if (grain.surface == static_cast<int>(surface)) parts.insert(grain.back.part);
  return parts;
}

/// Whether it is the same which of two surfaces a half shows, like the two rows of seeds of one carpel.
bool are_of_one_kind(const Template& fruit, std::size_t a, std::size_t b) {
  const SurfaceSketch &one = fruit.surfaces[a], &other = fruit.surfaces[b];
  return one.front.part == other.front.part && one.back.part == other.back.part &&
         are_level(heights_of(one), heights_of(other)) && grains_on(fruit, a) == grains_on(fruit, b);
}

}  // namespace

HalfTurn::HalfTurn(const Template& fruit, const std::vector<FoldSamples>& samples) {
  const auto& drawn = std::get<FoldSymmetry>(fruit.symmetry);
  std::vector<Sectors> sectors;
  for (std::size_t s = 0; s < samples.size(); ++s) {
    if (!samples[s].closed) continue;
    const auto of_its_kind = std::find_if(kinds_.begin(), kinds_.end(), [&](const Kind& kind) {
      return are_of_one_kind(fruit, samples[kind.samples.front()].surface, samples[s].surface);
    });
    const auto kind = static_cast<std::size_t>(of_its_kind - kinds_.begin());
    if (kind == kinds_.size()) kinds_.emplace_back(), sectors.emplace_back();
    kinds_[kind].samples.push_back(s);
    add_sectors(sectors[kind], drawn, samples[s].fold);
  }
  for (std::size_t k = 0; k < kinds_.size(); ++k) kinds_[k].shown = sides_shown(sectors[k]);
  const bool any = std::any_of(kinds_.begin(), kinds_.end(), [](const Kind& kind) { return kind.shown == 2; });
  shown_between_folds_ = any ? 0 : 2;
  drawn_score_ = score_at(sectors, sectors_between_folds(drawn), 0);
}

double HalfTurn::score_at(const std::vector<Sectors>& kinds, const Sectors& between_folds, double azimuth) const {
  double score = 0;
  for (std::size_t k = 0; k < kinds_.size(); ++k) {
    if (kinds_[k].shown > 0 && !kinds[k].empty()) score += worth(depth_on(kinds_[k].shown, kinds[k], azimuth));
  }
  if (shown_between_folds_ > 0) score += worth(depth_on(shown_between_folds_, between_folds, azimuth));
  return score;
}

double HalfTurn::operator()(const FoldSymmetry& variant, const std::vector<std::vector<PolarCurve>>& folds) const {
  std::vector<Sectors> sectors(kinds_.size());
  for (std::size_t k = 0; k < kinds_.size(); ++k)
    for (const std::size_t s : kinds_[k].samples) add_sectors(sectors[k], variant, folds[s]);
  const Sectors between_folds = sectors_between_folds(variant);
  double best = 0, best_score = score_at(sectors, between_folds, 0);
  if (best_score >= drawn_score_ - 1e-9) return 0;

  // Try turns in ascending size, to either side.
  for (int i = 1; i <= turns / 2; ++i) {
    for (const double azimuth : {pi * i / turns, -pi * i / turns}) {
      const double score = score_at(sectors, between_folds, azimuth);
      if (score > best_score + 1e-9) best = azimuth, best_score = score;
    }
  }
  return -best;
}

}  // namespace pomona
