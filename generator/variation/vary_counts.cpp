#include "generator/variation/vary_counts.h"

#include <algorithm>
#include <string>

namespace pomona {

int varied_folds(const Template& fruit, VariantKey key, double amount) {
  const int drawn = fold_count(fruit);
  const RandomStream random(key, "vary/counts/folds");
  if (random.uniform(1) >= amount) return drawn;
  double left = random.uniform(0);
  for (const CountVariation::Folds& folds : fruit.variation.counts.folds) {
    if (left < folds.share) return folds.number;
    left -= folds.share;
  }
  return drawn;
}

std::vector<bool> varied_presence(const Template& fruit, int surface, std::vector<bool> as_drawn, VariantKey key,
                                  double amount) {
  const std::vector<CountVariation::Presence>& all = fruit.variation.counts.present;
  const auto presence = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.surface == surface; });
  if (presence == all.end()) return as_drawn;
  const RandomStream random(key, "vary/counts/" + fruit.surfaces[static_cast<std::size_t>(surface)].name);
  for (std::size_t loop = 0; loop < as_drawn.size(); ++loop) {
    if (random.uniform(2 * loop + 1) < amount) as_drawn[loop] = random.uniform(2 * loop) < presence->share;
  }
  return as_drawn;
}

Template with_varied_layers(Template variant, VariantKey key, double amount) {
  for (std::size_t s = 0; s < variant.surfaces.size(); ++s) {
    SurfaceSketch& surface = variant.surfaces[s];
    if (surface.type != SurfaceType::around_axis) continue;
    if (varied_presence(variant, static_cast<int>(s), {true}, key, amount).front()) continue;
    surface.reference = reference_radii(surface);
    for (Curve& loop : surface.horizontal) loop.points.clear();
  }
  return variant;
}

}  // namespace pomona
