// Variants of cylindrical templates: all loops are synthesised together (paper, section 4.2, Figure 8 top).
#pragma once

#include <memory>

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/swept_check.h"

namespace pomona {

/// A cylindrical template that is prepared once and varied many times.
class LoopVariation {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit LoopVariation(const Template& fruit) : LoopVariation(fruit, SweptCheck(fruit)) {}

  /// \param swept the check of the drawing, if it exists already.
  LoopVariation(const Template& fruit, SweptCheck swept);

  /// All loops around the axis that vary are decomposed, and composed again by one common map [De Bonet 1997], so that
  /// layers still follow each other. Then layers that would cross are moved towards the next layer outside. What lies
  /// in folds stays as drawn.
  Template draw(VariantKey key, double amount) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace pomona
