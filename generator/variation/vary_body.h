// Beyond the paper: variants that differ as whole bodies, as the template's [variation] says.
#pragma once

#include "generator/base/random.h"
#include "generator/template/template.h"

namespace pomona {

/// The fruit in another size, with other proportions and another bend of its axis. The standard deviations are those
/// of `fruit.variation` times `amount`; no draw goes beyond two of them. Each draw depends on the key and on its own
/// name alone, so that one can be switched off and the others stay.
Template vary_body(const Template& fruit, VariantKey key, double amount);

/// Reduces a bend that would compress its inner side too much: to a compression of at most 0.6 and a lean of at most 60
/// degrees, or to those of `drawn` where these are larger.
Template gently_bent(Template fruit, const Template& drawn);

}  // namespace pomona
