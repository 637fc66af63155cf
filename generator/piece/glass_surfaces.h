// A fruit's diffusion surfaces as glass, for pictures like the paper's Figure 9.
#pragma once

#include <string>
#include <vector>

#include "generator/piece/grow.h"
#include "generator/piece/solid.h"

namespace pomona {

/// Every surface and every kind of grain as a see-through solid of its own, named "<name>.<surface>"; each side in its
/// own colours. What lies nearer to the axis is denser, grains most of all, so that one sees what lies in what. The
/// densest comes first: viewers of .glb that blend in the order of the file draw from the inside outwards. Blur is not
/// shown.
std::vector<Solid> glass_surfaces(const GrownFruit& fruit, const Template& variant, const std::string& name);

}  // namespace pomona
