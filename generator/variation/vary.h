// Variation: from a template to a variant of it (paper, section 4.2, Figure 8). Curves change, and beyond the paper
// what the template's [variation] names (vary_body.h, vary_counts.h). The surfaces swept from template and variant have
// the same triangles where the counts are equal: those of folds, and of surfaces that not all individuals have.
#pragma once

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/variation_options.h"

namespace pomona {

/// The variant for `key`: De Bonet synthesis of all loops together for cylindrical symmetry, blending of fold
/// samples by principal components for N-fold symmetry; then whatever `fruit.variation` asks for. Meshes do not vary:
/// without symmetry it is the template itself, and beside meshes only curves vary, so that all keeps together. \throws
/// Error (usage) if folds are asked of a template without them.
Template vary(const Template& fruit, VariantKey key, const VariationOptions& options = {});

/// The template as drawn, but with `folds` folds: the drawn folds repeated in turn.
Template with_folds(const Template& fruit, int folds);

}  // namespace pomona
