// Vertices and triangles as arrays of a glTF file.
#pragma once

#include <vector>

#include "render/export/gltf/gltf_document.h"
#include "render/export/styled_mesh.h"

namespace pomona::gltf {

/// Stores a mesh's vertices once, interleaved, and returns their attributes: POSITION, NORMAL, _PART, and COLOR_0; with
/// a texture TEXCOORD_0 instead, and TANGENT if it has a normal map; with a palette both. \param pivot becomes the
/// origin of positions.
Json add_vertices(GltfDocument& document, const StyledMesh& mesh, const glm::vec3& pivot);

/// The step of coded positions, metres: they are whole numbers of it, 16 bits each.
double coded_step(const StyledMesh& mesh, const glm::vec3& pivot);

/// Like add_vertices(), coded: positions in whole steps, so that nodes scale the mesh; normals and tangents in 8 bits,
/// colours in 12, texture coordinates in 16.
Json add_coded_vertices(GltfDocument& document, const StyledMesh& mesh, const glm::vec3& pivot);

/// Like add_triangles(), coded.
int add_coded_triangles(GltfDocument& document, const std::vector<glm::uvec3>& triangle, std::size_t vertices);

/// Stores triangles, with 16 bits per index if that is enough for so many vertices. Returns the index of the accessor.
int add_triangles(GltfDocument& document, const std::vector<glm::uvec3>& triangle, std::size_t vertices);

/// An accessor of bare positions, with their bounds.
int add_positions(GltfDocument& document, const std::vector<glm::vec3>& position);

}  // namespace pomona::gltf
