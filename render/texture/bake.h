// Baking: a solid's colours, noise and inner lines as a texture, for engines that want few vertices
// (docs/reference/textures.md).
#pragma once

#include <span>
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
  int mip_levels = 3;  ///< down to which no chart takes on another one's colours
  Maps maps = Maps::color;
  bool every_texel = false;  ///< diffuses each by itself, as a measure for others; slow
  Threads threads{};
};

/// A solid with texture coordinates; vertices are doubled along chart borders.
struct BakedSolid {
  Solid solid;
  std::vector<glm::vec2> uv;  ///< one per vertex; (0, 0) is the upper left corner of the texture
  Image texture;              ///< sRGB; 0 x 0 for a solid without triangles
  SurfaceMaps maps{};         ///< empty unless BakeOptions::maps asks for all

  int mip_levels = 0;  ///< as promised by BakeOptions, or fewer where charts are many and texels few
  double texel = 0;    ///< metres, exact on cut faces
  int charts = 0;
  double filled = 0;        ///< share of the texture that shows something
  double mean_stretch = 1;  ///< of skin, see Stretch
  double worst_stretch = 1;
  std::size_t diffused = 0;  ///< points at which colours were diffused, of solids of one fruit all with the first
};

/// The same bytes for the same solid, on any machine and for any number of threads, unless the solid's diffuser is
/// OpenGL. Texels of cut faces have the colours diffused around them if the solid has `section_colors` (face_colors.h);
/// all others interpolate the colours of vertices. Means of colours are taken in linear light.
/// \throws Error (usage) if there are too few texels, or `texel` asks for too many.
BakedSolid baked(const Solid& solid, const Style& style, const BakeOptions& options = {});

/// Many solids, one texture each; those beside each other that share their section_colors are diffused together.
std::vector<BakedSolid> all_baked(std::span<const Solid> solids, const Style& style, const BakeOptions& options = {});

}  // namespace pomona
