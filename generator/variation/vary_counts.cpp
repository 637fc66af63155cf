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

Template with_varied_presence(Template variant, VariantKey key, double amount) {
  const double natural = std::min(1.0, amount);
  for (const CountVariation::Presence& presence : variant.variation.counts.present) {
    SurfaceSketch& surface = variant.surfaces[static_cast<std::size_t>(presence.surface)];
    const RandomStream random(key, "vary/counts/" + surface.name);
    const double share = 1 - natural * (1 - presence.share);

    // What is left keeps the scale that all loops together gave the vertical curve.
    surface.reference = reference_radii(surface);
    for (std::size_t loop = 0; loop < surface.horizontal.size(); ++loop) {
      if (random.uniform(loop) >= share) surface.horizontal[loop].points.clear();
    }
  }
  return variant;
}

}  // namespace pomona
