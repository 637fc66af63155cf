// A fruit's diffusion surfaces as glass, for pictures like the paper's Figure 9.
#pragma once

#include <string>
#include <vector>

#include "generator/compose/grow.h"
#include "generator/piece/solid.h"

namespace pomona {

/// Every surface and every kind of grain as a transparent solid, named "<name>.<surface>"; each side has its own
/// colours. Surfaces nearer to the axis are more opaque, and grains most of all, so that inner things are visible
/// through outer ones. The most opaque solid comes first, because viewers of .glb that blend in the order of the file
/// then draw from the inside outwards. Blur is not shown.
std::vector<Solid> glass_surfaces(const GrownFruit& fruit, const Template& variant, const std::string& name);

}  // namespace pomona
