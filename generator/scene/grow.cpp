#include "generator/scene/grow.h"

#include "generator/surface/grains.h"
#include "generator/surface/sheets.h"
#include "generator/surface/sweep.h"
#include "generator/variation/vary.h"

namespace pomona {

Template variant_of(const Template& fruit, VariantKey key, const GrowOptions& options) {
  if (!options.as_drawn) return vary(fruit, key, {.amount = options.variation, .folds = options.folds});
  return options.folds ? with_folds(fruit, *options.folds) : fruit;
}

GrownFruit grow(const Template& variant, VariantKey key, const GrowOptions& options) {
  const SweepOptions sweep_options{.detail = options.detail, .key = key};
  GrownFruit grown;
  grown.swept = sweep(variant, sweep_options);
  grown.grains = scatter_grains(variant, key, sweep_options);
  grown.sheets = joined(sheets(grown.swept), sheets(grown.grains));
  return grown;
}

}  // namespace pomona
