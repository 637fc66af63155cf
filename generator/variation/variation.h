// A template that is prepared once and varied many times.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/swept_check.h"
#include "generator/variation/variation_options.h"
#include "generator/variation/vary_folds.h"
#include "generator/variation/vary_loops.h"

namespace pomona {

/// A variant, and how it came about.
struct Variant {
  Template fruit;
  std::vector<FoldReport> folds;  ///< none for cylindrical symmetry
};

/// draw() gives the result of vary() without preparing the drawing each time.
class Variation {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit Variation(const Template& fruit);

  const Template& drawn() const { return fruit_; }

  /// \throws Error (usage) as vary() does.
  Variant draw(VariantKey key, const VariationOptions& options = {}) const;

 private:
  static bool has_drawn_counts(const VariationOptions& options);

  Variant with_varied_curves(VariantKey key, const VariationOptions& options) const;

  Template with_varied_body(const Template& variant, VariantKey key, const VariationOptions& options) const;

  /// The variant with the body of the template, except for a bend that would make surfaces cross.
  Template with_drawn_body(const Template& variant) const;

  Template fruit_;
  std::optional<SweptCheck> swept_;  ///< none without symmetry: then nothing varies
  std::variant<std::monostate, LoopVariation, FoldVariation> curves_;
};

}  // namespace pomona
