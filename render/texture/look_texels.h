// How the parts of a solid take light, as texels of its maps.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/base/color.h"
#include "generator/piece/solid.h"
#include "render/style/pbr_look.h"

namespace pomona {

/// The numbers of a look as maps pack them (maps.h); colours are linear.
struct LookTexel {
  Color coat{0};  ///< clear coat, its roughness, 0
  float specular = 1;
  Color sheen{0};
  float sheen_roughness = 1;  ///< 1 where there is no sheen, too: shaders divide by it
  Color light{1};
  float light_share = 0;

  bool has_coat() const { return coat.r > 0 || specular < 1; }
  bool has_sheen() const { return sheen != Color(0); }
  bool lets_light_through() const { return light_share > 0; }
};

LookTexel look_texel(const PbrMaterial& look);

/// The looks of all parts of a solid.
class LookTexels {
 public:
  explicit LookTexels(const Solid& solid);

  /// That of a triangle of the solid.
  const LookTexel& of(std::uint32_t triangle) const;

  // What any triangle of the solid shows.
  bool any_coat() const { return any_coat_; }
  bool any_sheen() const { return any_sheen_; }
  bool any_light() const { return any_light_; }

 private:
  const Solid& solid_;
  std::vector<std::array<LookTexel, 2>> of_part_;  ///< on skins, on cut faces
  bool any_coat_ = false, any_sheen_ = false, any_light_ = false;
};

}  // namespace pomona
