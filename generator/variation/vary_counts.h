// How many folds a variant has, and which of its surfaces: what nature varies in number, beyond the paper's
// section 4.2.
#pragma once

#include <vector>

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

/// How many folds the variant has by the template's [variation]. With an amount below 1 so many more are as drawn.
int varied_folds(const Template& fruit, VariantKey key, double amount);

/// Which loops of a surface the variant has: those that it would have as drawn, unless the template says that not all
/// have it. With an amount below 1 so many more are as drawn.
std::vector<bool> varied_presence(const Template& fruit, int surface, std::vector<bool> as_drawn, VariantKey key,
                                  double amount);

/// The variant without the surfaces around the axis that its [variation] leaves out. They keep their numbers, but their
/// loops are empty.
Template with_varied_layers(Template variant, VariantKey key, double amount);

}  // namespace pomona
