// Baking: a solid's colours, noise and inner lines as a texture, for engines that want few vertices
// (docs/reference/textures.md).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/parallel.h"
#include "generator/piece/solid.h"
#include "render/image/image.h"
#include "render/style/style.h"
#include "render/texture/maps.h"

namespace pomona {

struct BakeOptions {
  int texels = 1024;   ///< along the texture's edge; a multiple of 2^mip_levels keeps all of these
  double texel = 0;    ///< metres: if above 0 the texture is as large as that asks for, and `texels` means nothing
  int mip_levels = 3;  ///< number of mip levels at which no chart gets colours of another
  Maps maps = Maps::color;
  bool looks = false;        ///< with all maps: they hold what else tells the parts' materials apart, too
  bool every_texel = false;  ///< diffuse at each texel, as a reference for measurements; slow
  Threads threads{};
};

/// A texture that several solids share (texture_pages.h).
struct TexturePage {
  std::string name;
  Image texture;
  SurfaceMaps maps{};  ///< without thickness, and without tangents, which stay with the solids
};

/// A solid with texture coordinates; vertices are doubled along chart borders.
struct BakedSolid {
  Solid solid;
  std::vector<glm::vec2> uv;                  ///< one per vertex; (0, 0) is the upper left corner of the texture
  Image texture;                              ///< sRGB; 0 x 0 for a solid without triangles
  SurfaceMaps maps{};                         ///< empty unless BakeOptions::maps asks for all
  std::shared_ptr<const TexturePage> page{};  ///< holds the texels in place of `texture` and `maps`; null: these do

  int mip_levels = 0;  ///< as in BakeOptions, or fewer if there are many charts and few texels
  double texel = 0;    ///< metres, exact on cut faces
  int charts = 0;
  double filled = 0;        ///< share of the texture that triangles cover
  double mean_stretch = 1;  ///< mean stretch of the skin, see Stretch
  double worst_stretch = 1;
  std::size_t diffused = 0;  ///< number of diffused points; for solids of one fruit, the first has the sum
};

/// Bakes one solid. The bytes are the same on any machine and for any number of threads, unless the solid's diffuser is
/// OpenGL. Texels of cut faces get diffused colours (face_colors.h) if the solid has `section_colors`; all others
/// interpolate the colours of vertices. Means of colours are computed in linear light.
/// \throws Error (usage) if there are too few texels, or `texel` asks for too many.
BakedSolid baked(const Solid& solid, const Style& style, const BakeOptions& options = {});

/// Bakes many solids, one texture each. Neighbours in the list with the same section_colors are diffused together.
std::vector<BakedSolid> all_baked(std::span<const Solid> solids, const Style& style, const BakeOptions& options = {});

}  // namespace pomona
