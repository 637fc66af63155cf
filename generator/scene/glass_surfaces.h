// A fruit's diffusion surfaces as glass, for pictures like the paper's Figure 9.
#pragma once

#include <string>
#include <vector>

#include "generator/scene/grow.h"
#include "generator/scene/solid.h"

namespace pomona {

/// Every surface and every kind of grain as a see-through solid of its own, named "<name>.<surface>"; each side in its
/// own colours. The skin is faint, what lies within is fainter the more there is of it, small things are denser, so
/// that one sees what lies in what. Blur is not shown.
std::vector<Solid> glass_surfaces(const GrownFruit& fruit, const Template& variant, const std::string& name);

}  // namespace pomona
