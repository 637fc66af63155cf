// Grows a fruit: from a template and a seed to everything that the diffuser sees. This is the first half of the road.
#pragma once

#include "generator/base/random.h"
#include "generator/compose/grown_fruit.h"
#include "generator/template/template.h"
#include "generator/variation/variation.h"

namespace pomona {

/// The template's variant for `key`, with its own patterns of noise and detail. With as_drawn, it is the template
/// itself, or the template with its folds repeated in turn, with the given ripeness.
Template variant_of(const Template& fruit, VariantKey key, const GrowOptions& options = {});

/// The same for a template that is prepared for many variants; never as drawn.
Template variant_of(const Variation& variation, VariantKey key, const GrowOptions& options = {});

/// Sweeps a variant, ripens its colours, splits its blur and scatters its grains; sets into it what it places.
GrownFruit grow(const Template& variant, VariantKey key, const GrowOptions& options = {});

}  // namespace pomona
