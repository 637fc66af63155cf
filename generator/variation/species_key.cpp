#include "generator/variation/species_key.h"

#include <string>

namespace pomona {

VariantKey species_key(VariantKey key, std::string_view species) {
  if (key.seed == 0 && key.index == 0) return key;
  const RandomStream own(key, "species/" + std::string(species));
  return {own.bits(0), own.bits(1)};
}

}  // namespace pomona
