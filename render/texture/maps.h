// The maps of a texture besides colours: normals, roughness, thickness (docs/reference/textures.md).
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "generator/order/export_choices.h"
#include "render/image/image.h"

namespace pomona {

/// The maps, on the atlas of the texture, as in glTF: values are shares of 255, not sRGB. 0 x 0 if there are none.
struct SurfaceMaps {
  Image normal;     ///< n of the tangent frame as (n + 1) / 2; level: (128, 128, 255)
  Image orm;        ///< occlusion, roughness, metal (none)
  Image thickness;  ///< in green: of what light passes through, share of max_thickness; in red: share of a cut face's
                    ///< film
  Image part;       ///< the part's number in Solid::part_names, in all channels; 255 where there is none

  // How the parts take light, as glTF packs it, where one material is for all of them (BakeOptions::looks). Each is
  // 0 x 0 if it has nothing to tell: no coat and no dull skin, no sheen, no light.
  TransparentImage coat;   ///< red: clear coat; green: its roughness; opacity: how much the surface mirrors, specular
  TransparentImage sheen;  ///< colour, sRGB; opacity: roughness
  TransparentImage light;  ///< of what comes out behind: colour, sRGB; opacity: share
  bool tell_looks = false;

  std::vector<glm::vec4> tangent;  ///< per vertex: the direction of u, and 1: v runs against n x u

  bool empty() const { return normal.pixels.empty(); }
};

/// Metres: thicker parts count as this thick.
constexpr double max_thickness = 0.006;

}  // namespace pomona
