#include "render/texture/look_texels.h"

#include <algorithm>
namespace pomona {

namespace {

Color color_of(const std::array<double, 3>& linear) { return Color(glm::dvec3(linear[0], linear[1], linear[2])); }

}  // namespace

LookTexel look_texel(const PbrMaterial& look) {
  return {.coat = Color(glm::dvec3(look.clearcoat, look.clearcoat_roughness, 0)),
          .specular = static_cast<float>(look.specular),
          .sheen = color_of(look.sheen),
          .sheen_roughness = look.sheen_roughness > 0 ? static_cast<float>(look.sheen_roughness) : 1,
          .light = color_of(look.transmission_color),
          .light_share = static_cast<float>(look.transmission)};
}

LookTexels::LookTexels(const Solid& solid) : solid_(solid) {
  // Without materials all parts have the look of what is not described.
  const bool has_materials = !solid.look->materials.empty();
  for (std::size_t part = 0; part < std::max<std::size_t>(solid.look->part_names.size(), 1); ++part) {
    const MaterialSketch material = material_of(solid, static_cast<std::int32_t>(part));
    of_part_.push_back({has_materials ? look_texel(look_of(material, false)) : LookTexel{},
                        has_materials ? look_texel(look_of(material, true)) : LookTexel{}});
  }
  for (std::uint32_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    const LookTexel& look = of(t);
    any_coat_ = any_coat_ || look.has_coat();
    any_sheen_ = any_sheen_ || look.has_sheen();
    any_light_ = any_light_ || look.lets_light_through();
  }
}

const LookTexel& LookTexels::of(std::uint32_t triangle) const {
  const std::int32_t part = solid_.mesh.part[solid_.mesh.triangle[triangle].x];
  const auto number = std::min(static_cast<std::size_t>(std::max(part, 0)), of_part_.size() - 1);
  return of_part_[number][solid_.mesh.cut_face[triangle] >= 0 ? 1 : 0];
}

}  // namespace pomona
