// A single seed, for plates.
#pragma once

#include <optional>
#include <string>

#include "generator/compose/grow.h"
#include "generator/piece/solid.h"

namespace pomona {

/// The longest of the grains whose part is called seed, stone, pip, achene or kernel, as a solid at the place where it
/// grew; nothing if there is none.
std::optional<Solid> one_grain(const GrownFruit& fruit, const Template& variant, const std::string& name);

}  // namespace pomona
