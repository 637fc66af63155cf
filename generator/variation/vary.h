// Variation: from a template to a variant of it (paper, section 4.2, Figure 8). Curves change; beyond the paper also
// what the template's [variation] names (vary_body.h, vary_counts.h). The surfaces swept from template and variant have
// the same triangles, if they have the same number of folds and of optional surfaces.
#pragma once

#include "generator/base/random.h"
#include "generator/template/template.h"
#include "generator/variation/variation_options.h"

namespace pomona {

/// The variant for `key`. For cylindrical symmetry: De Bonet synthesis of all loops together. For N-fold symmetry:
/// blends of the fold samples by principal components. Then the changes that `fruit.variation` asks for. Meshes do not
/// vary: without symmetry the result is the template itself; in a template with meshes only curves vary, so that they
/// still fit. \throws Error (usage) if `folds` is given for a template without folds.
Template vary(const Template& fruit, VariantKey key, const VariationOptions& options = {});

/// The template as drawn, but with `folds` folds: the drawn folds repeated in turn.
Template with_folds(const Template& fruit, int folds);

}  // namespace pomona
