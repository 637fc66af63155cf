// One solid as a class prim of a USD file, which instances refer to.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "render/export/convex_hull.h"
#include "render/export/styled_mesh.h"
#include "render/export/usd/usda_material.h"

namespace pomona::usd {

/// A solid in its colours, or one of its levels of detail.
struct StyledLevel {
  const Solid& solid;
  const StyledMesh& mesh;
  std::string texture =
      {};  ///< the file with its colours, for the mesh's texture coordinates; empty if vertices have colours

  // Where maps tell looks.
  std::vector<MaterialGroup> in_maps = {};  ///< of groups_in_maps(); none where each look has a material
  std::string material = {};                ///< its name
  MapFiles maps = {};                       ///< none on a palette
};

/// "def Xform NAME { ... }", a component: its mesh or, for several levels, the variant set LOD; mass, labels, and the
/// command that makes it again. \param levels the solid first. \param parts it collides by; its mesh serves where there
/// are none. \param looks receives the materials that it needs. \param choices of textures for the solid, as the
/// variant set "ripeness", the first selected; or none.
std::string piece_text(const std::string& name, std::span<const StyledLevel> levels, std::span<const ConvexHull> parts,
                       Looks& looks, const ExportOptions& options, std::span<const TextureChoice> choices = {});

/// A class for one that lies where neighbours leave less room than its piece's hulls take: who inherits it, and refers
/// to the piece, collides by these parts. \param level the solid, whose looks are known.
std::string settled_text(const std::string& name, const StyledLevel& level, std::span<const ConvexHull> parts,
                         Looks& looks, const ExportOptions& options);

}  // namespace pomona::usd
