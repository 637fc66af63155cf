// How many folds a variant has, and which of its surfaces: what nature varies in number, beyond the paper's
// section 4.2.
#pragma once

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

/// How many folds the variant has by the template's [variation]. With an amount below 1 so many more are as drawn.
int varied_folds(const Template& fruit, VariantKey key, double amount);

/// The variant without the surfaces, or without the loops of folds, that its [variation] leaves out. Surfaces keep
/// their numbers; one that is left out has empty loops.
Template with_varied_presence(Template variant, VariantKey key, double amount);

}  // namespace pomona
