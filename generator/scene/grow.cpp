#include "generator/scene/grow.h"

#include <utility>

#include "generator/surface/grains.h"
#include "generator/surface/sheets.h"
#include "generator/surface/skin_depth.h"
#include "generator/surface/sweep.h"
#include "generator/variation/individual_colors.h"
#include "generator/variation/ripen.h"

namespace pomona {

namespace {

/// The variant with colours of its own.
Template colored_individual(Template variant, const Template& fruit, VariantKey key, const GrowOptions& options) {
  const double amount = options.as_drawn || options.curves_only ? 0 : options.variation;
  variant.individual =
      drawn_individual(fruit, key, {.amount = amount, .ripeness = options.ripeness, .browning = options.browning});
  return variant;
}

}  // namespace

Template variant_of(const Template& fruit, VariantKey key, const GrowOptions& options) {
  if (!options.as_drawn) return variant_of(Variation(fruit), key, options);
  return colored_individual(options.folds ? with_folds(fruit, *options.folds) : fruit, fruit, key, options);
}

Template variant_of(const Variation& variation, VariantKey key, const GrowOptions& options) {
  const Template& fruit = variation.drawn();
  const VariationOptions how{.amount = options.variation, .folds = options.folds, .curves_only = options.curves_only};
  return colored_individual(variation.draw(key, how).fruit, fruit, key, options);
}

GrownFruit grow(const Template& variant, VariantKey key, const GrowOptions& options) {
  const SweepOptions sweep_options{.detail = options.detail, .key = key};
  GrownFruit grown;
  grown.swept = sweep(variant, sweep_options);
  grown.grains = scatter_grains(variant, key, sweep_options);
  if (has_own_colors(variant)) {
    const SkinDepth skin(grown.swept);
    grown.swept = ripened(std::move(grown.swept), variant, skin);
    grown.grains = ripened(std::move(grown.grains), variant, skin);
  }
  grown.sheets = joined(sheets(grown.swept), sheets(grown.grains));
  return grown;
}

}  // namespace pomona
