// Looks as texels of small maps beside the colours of vertices: one material for parts that would have several.
#pragma once

#include <map>
#include <vector>

#include <glm/vec2.hpp>

#include "render/export/pbr_material.h"
#include "render/export/styled_mesh.h"
#include "render/texture/maps.h"

namespace pomona {

/// Gives each look a few texels of its own. All corners of a triangle lie at one place, so that no picture mixes looks.
class LookPalette {
 public:
  /// Where the look's texels lie, (0, 0) the upper left corner: the same for the same look.
  /// \throws Error (bad_data) for more than 1024 looks.
  glm::vec2 place_of(const PbrMaterial& look);

  /// Roughness; and of coat, sheen and light those maps that have something to tell.
  SurfaceMaps maps() const;

 private:
  std::map<PbrMaterial, std::size_t> known_;
  std::vector<PbrMaterial> looks_;
};

/// A mesh with StyledMesh::look_place, and its groups.
struct MeshOnPalette {
  StyledMesh mesh;
  std::vector<MaterialGroup> groups;  ///< of groups_in_maps()
};

/// Vertices that triangles of several looks share are doubled. \param groups of the mesh, a look each.
MeshOnPalette on_palette(const StyledMesh& mesh, std::vector<MaterialGroup> groups, LookPalette& palette);

}  // namespace pomona
