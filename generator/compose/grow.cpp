#include "generator/compose/grow.h"

#include <optional>
#include <span>
#include <utility>
#include <variant>

#include "generator/base/random.h"
#include "generator/compose/placed_instances.h"
#include "generator/surface/grains/grains.h"
#include "generator/surface/grains/walls_in_grains.h"
#include "generator/surface/sheets.h"
#include "generator/surface/skin_depth.h"
#include "generator/surface/sweep/swept_fruit.h"
#include "generator/variation/individual_colors.h"
#include "generator/variation/ripen.h"
#include "generator/variation/scaled.h"
#include "generator/variation/species_key.h"
#include "generator/variation/vary.h"

namespace pomona {

namespace {

/// Without variation, and as drawn, noise and detail keep the drawing's pattern.
std::uint32_t drawn_pattern(const Template& fruit, VariantKey key, const GrowOptions& options) {
  if (options.as_drawn || std::holds_alternative<NoSymmetry>(fruit.symmetry)) return 0;
  return 1 + static_cast<std::uint32_t>(RandomStream(key, "pattern").below(0, max_pattern));
}

/// The variant with colours, noise and detail of its own.
Template colored_individual(Template variant, const Template& fruit, VariantKey users_key, const GrowOptions& options) {
  const VariantKey key = species_key(users_key, fruit.name);
  const double amount = options.as_drawn || options.curves_only ? 0 : options.variation;
  variant.individual =
      drawn_individual(fruit, key, {.amount = amount, .ripeness = options.ripeness, .browning = options.browning});
  variant.noise.pattern = drawn_pattern(fruit, key, options);
  for (DetailSketch& detail : variant.details) detail.pattern = variant.noise.pattern;
  return options.scale == 1 ? variant : scaled(std::move(variant), options.scale);
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

namespace {

GrownFruit grow_unsplit(const Template& variant, VariantKey users_key, const GrowOptions& options);

/// One individual for each key.
std::vector<GrownFruit> grow_placed(const Template& placed, std::span<const VariantKey> keys,
                                    const GrowOptions& options) {
  std::optional<Variation> variation;
  if (!options.as_drawn) variation.emplace(placed);
  GrowOptions own = options;
  if (keys.size() > 1) own.threads = {1};
  std::vector<GrownFruit> grown(keys.size());
  parallel_for(keys.size(), options.threads, [&](std::size_t i) {
    const Template variant = variation ? variant_of(*variation, keys[i], own) : variant_of(placed, keys[i], own);
    grown[i] = grow_unsplit(variant, keys[i], own);
  });
  return grown;
}

/// All of it before blur is split.
GrownFruit grow_unsplit(const Template& variant, VariantKey users_key, const GrowOptions& options) {
  const VariantKey key = species_key(users_key, variant.name);
  const SweepOptions sweep_options{.detail = options.detail, .key = key, .threads = options.threads};
  GrownFruit grown;
  SweptFruit swept = swept_fruit(variant, sweep_options);
  grown.swept = std::move(swept.surfaces);
  grown.raised = std::move(swept.raised);
  grown.grains = scatter_grains(variant, key, sweep_options);
  if (has_own_colors(variant)) {
    grown.skin = std::make_shared<const SkinDepth>(grown.swept);
    const std::vector<glm::dvec3> leads = tissue_colors(grown.swept, grown.grains, variant);
    grown.swept = ripened(std::move(grown.swept), variant, *grown.skin, leads, options.threads);
    grown.grains = ripened(std::move(grown.grains), variant, *grown.skin, leads, options.threads);
  }
  return with_placed(std::move(grown), variant, key, options, grow_placed);
}

}  // namespace

GrownFruit grow(const Template& variant, VariantKey key, const GrowOptions& options) {
  GrownFruit grown = grow_unsplit(variant, key, options);
  const DiffusionSurfaces walls =
      without_walls_in_grains(sheets(grown.swept), grown.grains, variant.spared, options.threads);
  grown.sheets = joined(walls, sheets(grown.grains));
  return grown;
}

}  // namespace pomona
