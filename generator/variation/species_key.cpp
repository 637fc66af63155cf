#include "generator/variation/species_key.h"

#include <string>

namespace pomona {

bool is_drawn(VariantKey key) { return key.seed == 0 && key.index == 0; }

VariantKey species_key(VariantKey key, std::string_view species) {
  if (is_drawn(key)) return key;
  const RandomStream own(key, "species/" + std::string(species));
  return {own.bits(0), own.bits(1)};
}

}  // namespace pomona
