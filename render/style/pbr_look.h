// How a part of a solid takes light, for physically based rendering (PBR), as in glTF.
#pragma once

#include <array>
#include <compare>

#include "generator/template/material_sketch.h"
#include "render/style/tissue_light.h"

namespace pomona {

/// The factors of a glTF material and of its extensions. The defaults are those of parts without a description: dull
/// like flesh, without extensions.
struct PbrMaterial {
  double roughness = 0.6;
  double specular = 1;                            ///< KHR_materials_specular
  double clearcoat = 0, clearcoat_roughness = 0;  ///< KHR_materials_clearcoat
  std::array<double, 3> sheen{};                  ///< KHR_materials_sheen: colour, linear
  double sheen_roughness = 0;
  double transmission = 0;  ///< KHR_materials_diffuse_transmission
  std::array<double, 3> transmission_color{1, 1, 1};
  double clearness = 0;  ///< KHR_materials_transmission: of light that goes straight through
  TissueLight inside{};  ///< where it is asked for, see groups_by_material() in render/export/pbr_material.h

  auto operator<=>(const PbrMaterial&) const = default;
};

/// Smooth and wet parts have a clear coat, hairs and bloom are a sheen, translucent parts let diffuse light through.
PbrMaterial look_of(const MaterialSketch& material, bool on_cut_face);

}  // namespace pomona
