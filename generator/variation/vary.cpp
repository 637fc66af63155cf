#include "generator/variation/vary.h"

#include <string>
#include <utility>

#include "generator/base/error.h"
#include "generator/variation/species_key.h"
#include "generator/variation/variation.h"
#include "generator/variation/vary_body.h"
#include "generator/variation/vary_counts.h"

namespace pomona {

namespace {

void check_folds(const Template& fruit, int folds) {
  if (!std::holds_alternative<FoldSymmetry>(fruit.symmetry)) {
    throw Error(ExitStatus::usage, "template \"" + fruit.name + "\" has no folds to change",
                "leave out --folds: the template's symmetry has none");
  }
  if (folds < 1 || folds > max_folds) {
    throw Error(ExitStatus::usage,
                "a fruit has 1 to " + std::to_string(max_folds) + " folds, not " + std::to_string(folds));
  }
}

std::optional<SweptCheck> swept_check_of(const Template& fruit) {
  if (std::holds_alternative<NoSymmetry>(fruit.symmetry)) return {};
  return SweptCheck(fruit);
}

std::variant<std::monostate, LoopVariation, FoldVariation> curves_of(const Template& fruit,
                                                                     const std::optional<SweptCheck>& swept) {
  if (!swept) return {};
  if (std::holds_alternative<CylindricalSymmetry>(fruit.symmetry)) return LoopVariation(fruit, *swept);
  return FoldVariation(fruit, *swept);
}

}  // namespace

Variation::Variation(const Template& fruit)
    : fruit_(fruit), swept_(swept_check_of(fruit)), curves_(curves_of(fruit, swept_)) {}

Variant Variation::draw(VariantKey key, const VariationOptions& options) const {
  if (!(options.amount >= 0 && options.amount <= 2)) {
    throw Error(ExitStatus::usage, "the amount of variation must lie between 0 and 2");
  }
  if (options.folds) check_folds(fruit_, *options.folds);
  if (std::holds_alternative<NoSymmetry>(fruit_.symmetry)) return {fruit_, {}};
  const VariantKey own = species_key(key, fruit_.name);
  Variant variant = with_varied_curves(own, options);
  variant.fruit = with_varied_body(variant.fruit, own, options);
  if (!has_drawn_counts(options)) variant.fruit = with_varied_layers(std::move(variant.fruit), own, options.amount);
  return variant;
}

bool Variation::has_drawn_counts(const VariationOptions& options) {
  return options.drawn_counts || options.curves_only;
}

Template Variation::with_varied_body(const Template& variant, VariantKey key, const VariationOptions& options) const {
  if (options.curves_only || !fruit_.meshes.empty()) return gently_bent(variant, fruit_);
  // A map of space cannot make smooth surfaces cross, but close facets may cross. Then the body stays nearer to the
  // drawing.
  for (double share = 1; share > 0.3; share *= 0.7) {
    Template body = gently_bent(vary_body(variant, key, share * options.amount), fruit_);
    if (!swept_->crosses_anew(body)) return body;
  }
  return with_drawn_body(variant);
}

Template Variation::with_drawn_body(const Template& variant) const {
  // The curves were checked on the straight axis. If the bend makes facets cross, the axis stays straighter.
  Template body = gently_bent(variant, fruit_);
  for (int attempt = 0; attempt < 6 && swept_->crosses_anew(body); ++attempt) {
    body.bend.angle *= 0.7;
    body.bend.swing *= 0.7;
  }
  if (swept_->crosses_anew(body)) body.bend = body.bend.as_line();
  return body;
}

Variant Variation::with_varied_curves(VariantKey key, const VariationOptions& options) const {
  if (const auto* loops = std::get_if<LoopVariation>(&curves_)) return {loops->draw(key, options.amount), {}};
  const int natural = has_drawn_counts(options) ? fold_count(fruit_) : varied_folds(fruit_, key, options.amount);
  FoldVariant variant = std::get<FoldVariation>(curves_).draw(key, options.amount, options.folds.value_or(natural),
                                                              has_drawn_counts(options));
  return {std::move(variant.fruit), std::move(variant.folds)};
}

Template vary(const Template& fruit, VariantKey key, const VariationOptions& options) {
  return Variation(fruit).draw(key, options).fruit;
}

Template with_folds(const Template& fruit, int folds) {
  check_folds(fruit, folds);
  return repeat_folds(fruit, folds);
}

}  // namespace pomona
