// Variants of cylindrical templates: all loops synthesised together (paper, section 4.2, Figure 8 top).
#pragma once

#include <memory>

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/swept_check.h"

namespace pomona {

/// A cylindrical template made ready to be varied many times.
class LoopVariation {
 public:
  /// \throws Error (bad_data) if the drawing cannot be swept.
  explicit LoopVariation(const Template& fruit) : LoopVariation(fruit, SweptCheck(fruit)) {}

  /// `swept` is the drawing's, where that has been looked at before.
  LoopVariation(const Template& fruit, SweptCheck swept);

  /// Every loop around the axis that varies is taken apart with the others and put together anew by one map
  /// [De Bonet 1997], so that layers keep following each other; then layers that would cross are drawn
  /// nearer to the next layer outside them. What lies in folds stays as drawn.
  Template draw(VariantKey key, double amount) const;

 private:
  struct Prepared;
  std::shared_ptr<const Prepared> prepared_;
};

}  // namespace pomona
