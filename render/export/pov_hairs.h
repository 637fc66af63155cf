// The hairs of a solid for POV-Ray: each hair is three thin triangles.
#pragma once

#include <cstddef>
#include <string>

#include "generator/piece/solid.h"

namespace pomona::pov {

/// "#declare Fuzz_<index> = mesh2 { ... }" in units of 10^unit_exponent metres; empty for a solid without fuzz.
std::string hairs_text(const Solid& solid, std::size_t index, int unit_exponent);

}  // namespace pomona::pov
