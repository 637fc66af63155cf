#include "generator/variation/vary.h"

#include <string>

#include "generator/base/error.h"
#include "generator/variation/vary_body.h"
#include "generator/variation/vary_folds.h"
#include "generator/variation/vary_loops.h"

namespace pomona {

namespace {

constexpr int most_folds = 64;

void check_folds(const Template& fruit, int folds) {
  if (!std::holds_alternative<FoldSymmetry>(fruit.symmetry)) {
    throw Error(ExitStatus::usage, "template \"" + fruit.name + "\" has no folds to change",
                "leave out --folds: the template's symmetry has none");
  }
  if (folds < 1 || folds > most_folds) {
    throw Error(ExitStatus::usage,
                "a fruit has 1 to " + std::to_string(most_folds) + " folds, not " + std::to_string(folds));
  }
}

Template with_varied_curves(const Template& fruit, VariantKey key, const VariationOptions& options) {
  if (std::holds_alternative<CylindricalSymmetry>(fruit.symmetry)) return vary_loops(fruit, key, options.amount);
  return vary_folds(fruit, key, options.amount, options.folds.value_or(fold_count(fruit))).fruit;
}

}  // namespace

Template vary(const Template& fruit, VariantKey key, const VariationOptions& options) {
  if (!(options.amount >= 0 && options.amount <= 2)) {
    throw Error(ExitStatus::usage, "the amount of variation must lie between 0 and 2");
  }
  if (options.folds) check_folds(fruit, *options.folds);
  if (std::holds_alternative<NoSymmetry>(fruit.symmetry)) return fruit;
  Template variant = with_varied_curves(fruit, key, options);
  if (!options.curves_only && fruit.meshes.empty()) variant = vary_body(variant, key, options.amount);
  return gently_bent(std::move(variant), fruit);
}

Template with_folds(const Template& fruit, int folds) {
  check_folds(fruit, folds);
  return repeat_folds(fruit, folds);
}

}  // namespace pomona
