// USD in its text form (.usda): for Omniverse, Houdini, Maya, Blender (docs/reference/formats.md).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/export/named_file.h"
#include "render/export/styled_mesh.h"
#include "render/export/texture_variant.h"

namespace pomona {

/// The bytes of a .usda: a class prim per solid, a reference to it per instance, the scene's camera. Metres, +Y up
/// unless the options say +Z; colours of vertices as displayColor, linear. Same scene and options, same bytes.
/// \param levels one entry per solid of the scene, or none: its coarser levels, finer before coarser, as variants LOD1,
/// LOD2, ... of the variant set LOD.
std::string write_usda(const Scene& scene, const ExportOptions& options = {},
                       std::span<const std::vector<Solid>> levels = {});

/// A .usda and its pictures.
struct UsdaFiles {
  std::string text;
  std::vector<NamedFile> textures;  ///< .png
};

/// The same, with options.atlas: a look is a place on pictures "`stem`_looks_orm.png", ..., in place of a material.
UsdaFiles write_usda(const Scene& scene, const std::string& stem, const ExportOptions& options,
                     std::span<const std::vector<Solid>> levels = {});

/// The same with the colours in textures, "`stem`_PIECE.png": `baked` and the levels have one entry per solid of the
/// scene. Where maps tell looks they are files, too, and a piece has one material; pages are shared. \param variants as
/// the variant set "ripeness", after "as_is". \throws Error (bug) if a variant has another atlas than its solid.
UsdaFiles write_usda(const Scene& scene, std::span<const BakedSolid> baked, const std::string& stem,
                     const ExportOptions& options = {}, std::span<const std::vector<BakedSolid>> levels = {},
                     std::span<const TextureVariant> variants = {});

}  // namespace pomona
