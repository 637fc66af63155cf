// The colours and the ripeness of an individual, drawn at random.
#pragma once

#include <optional>

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

struct ColorOptions {
  double amount = 1;                    ///< factor of the random variation: 0 = none, 1 = as declared, 2 = twice
  std::optional<double> ripeness = {};  ///< 0..2, instead of a random one
  double browning = 0;                  ///< 0..1
};

/// The individual for `key`, with the template's [variation]. Each value is within two standard deviations. The values
/// of one part do not depend on what is declared of another. \throws Error (usage) if ripeness or browning are asked of
/// a template that does not declare them.
Individual drawn_individual(const Template& fruit, VariantKey key, const ColorOptions& options = {});

}  // namespace pomona
