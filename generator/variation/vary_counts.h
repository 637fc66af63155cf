// The number of folds of a variant, and which of its surfaces it has (beyond the paper's section 4.2).
#pragma once

#include <vector>

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

/// The number of folds of the variant, by the template's [variation]. The smaller `amount` is below 1, the more
/// variants have the drawn number.
int varied_folds(const Template& fruit, VariantKey key, double amount);

/// The loops of a surface that the variant has: those of the drawing, unless the template says that not all individuals
/// have the surface. The smaller `amount` is below 1, the more variants are as drawn.
std::vector<bool> varied_presence(const Template& fruit, int surface, std::vector<bool> as_drawn, VariantKey key,
                                  double amount);

/// The variant without the surfaces around the axis that its [variation] leaves out. They keep their numbers, but their
/// loops are empty.
Template with_varied_layers(Template variant, VariantKey key, double amount);

}  // namespace pomona
