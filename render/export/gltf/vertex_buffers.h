// Vertices and triangles as arrays of a glTF file.
#pragma once

#include <vector>

#include "render/export/gltf/gltf_document.h"
#include "render/export/styled_mesh.h"

namespace pomona::gltf {

/// Lays a mesh's vertices down once, interleaved, and returns the attributes over them: POSITION, NORMAL, _PART, and
/// COLOR_0 or, where there is a texture, TEXCOORD_0, and TANGENT where that has a normal map.
/// \param pivot becomes the origin of positions.
Json add_vertices(GltfDocument& document, const StyledMesh& mesh, const glm::vec3& pivot);

/// The index of an accessor: 16 bits, as long as that is enough for so many vertices.
int add_triangles(GltfDocument& document, const std::vector<glm::uvec3>& triangle, std::size_t vertices);

/// An accessor of bare positions, with their bounds.
int add_positions(GltfDocument& document, const std::vector<glm::vec3>& position);

}  // namespace pomona::gltf
