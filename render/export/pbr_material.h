// The materials of a mesh for physically based rendering (PBR), as in glTF.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/export/styled_mesh.h"
#include "render/style/pbr_look.h"

namespace pomona {

/// The triangles of a mesh with one material. Groups are in the order in which their materials first occur. There is
/// one group if the solid's template has no materials.
struct MaterialGroup {
  PbrMaterial look;
  std::string name;                  ///< name of the part: "skin", "gel", "inside"; empty if all parts have this
                                     ///< material
  std::vector<std::int32_t> face;    ///< indices of its triangles in the mesh, sorted
  std::vector<glm::uvec3> triangle;  ///< these triangles
};
enum class LightInside { left_out, told };
std::vector<MaterialGroup> groups_by_material(const Solid& solid, const StyledMesh& mesh,
                                              LightInside light = LightInside::left_out);

/// The groups as one, for a material whose maps tell looks; and another one, "clear", of what light goes straight
/// through, because engines draw it by itself. What no map tells is as in the group of the most triangles.
std::vector<MaterialGroup> groups_in_maps(const std::vector<MaterialGroup>& groups);

}  // namespace pomona
