// What light does in a part of a fruit, as path tracers want it: numbers for each kind of tissue.
#pragma once

#include <array>
#include <compare>
#include <string_view>

#include "generator/template/material_sketch.h"

namespace pomona {

/// Scattering under the surface, per channel of linear light. The default is that of what light does not enter.
struct TissueLight {
  double weight = 0;               ///< share of what is not mirrored that goes in and comes out elsewhere, 0..1
  std::array<double, 3> radius{};  ///< mean way between the two, metres; in steps of 0.01 mm

  auto operator<=>(const TissueLight&) const = default;
};

/// What the material says; else by its translucency, whose depth times its colour is the way; else by its tissue, or by
/// the kind that a part of this name usually is.
TissueLight tissue_light(const MaterialSketch& material, std::string_view part);

/// "gel" is gel, "calyx" a leaf, what is not known is flesh.
Tissue usual_tissue(std::string_view part);

}  // namespace pomona
