// Beyond the paper: variants that differ as whole bodies, as the template's [variation] says.
#pragma once

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

/// The fruit in another size, with other proportions and another bend of its axis. The standard deviations are those
/// of `fruit.variation` times `amount`; no draw goes beyond two of them. Each draw depends on the key and on its own
/// name alone, so that one can be switched off and the others stay.
Template vary_body(const Template& fruit, VariantKey key, double amount);

/// A bend that would press too hard on what lies on its inner side is made gentler: to a pressing of 0.6 and a lean
/// of 60 degrees at most, or to as much as `drawn` has.
Template gently_bent(Template fruit, const Template& drawn);

}  // namespace pomona
