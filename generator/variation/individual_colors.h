// Colour and ripeness of individuals: which ones a variant draws.
#pragma once

#include <optional>

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

struct ColorOptions {
  double amount = 1;                    ///< of the drawn variation: 0 = none, 1 = as declared, 2 = twice
  std::optional<double> ripeness = {};  ///< 0..2 instead of a drawn one
  double browning = 0;                  ///< 0..1
};

/// What `key` draws within the template's [variation], each draw within two standard deviations. Draws of one part do
/// not depend on what is declared of another.
/// \throws Error (usage) if ripeness or browning are asked of a template that does not declare them.
Individual drawn_individual(const Template& fruit, VariantKey key, const ColorOptions& options = {});

}  // namespace pomona
