// One solid as a mesh of a glTF file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/export/gltf/gltf_document.h"
#include "render/export/gltf/piece_materials.h"
#include "render/export/styled_mesh.h"

namespace pomona::gltf {

struct PieceMeshOptions {
  std::string name;                            ///< name of the mesh
  glm::vec3 pivot{0};                          ///< becomes the origin
  std::optional<PieceTextures> textures = {};  ///< textures of PieceMaterials; nothing if vertices have colours

  std::vector<int> variant_textures = {};  ///< the colours of each of the file's variants, or none at all
};

/// A primitive for each look, all of the same vertices, and `extras`. The index of the mesh.
/// \throws Error (bad_data) for a solid with more than 65 536 parts.
int add_piece_mesh(GltfDocument& document, PieceMaterials& materials, const Solid& solid, const StyledMesh& styled,
                   const PieceMeshOptions& mesh, const ExportOptions& options);

}  // namespace pomona::gltf
