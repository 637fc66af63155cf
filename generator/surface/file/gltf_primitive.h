// The triangles of one primitive of a glTF mesh.
#pragma once

#include <cstddef>
#include <vector>

#include <tiny_gltf.h>
#include <glm/mat4x4.hpp>

#include "generator/surface/file/gltf_accessors.h"
#include "generator/surface/file/plain_mesh.h"

namespace pomona {

/// Where the node of a primitive puts its points: by a transform, or, where joints and their weights are given, by
/// these.
struct PrimitivePose {
  glm::dmat4 to_scene{1};
  std::vector<glm::dmat4> joints;     ///< for points of the mesh; empty without a skin
  std::vector<double> morph_weights;  ///< one for each target, or none
};

/// How much more a file may hold.
struct MeshRoom {
  std::size_t vertices = 5'000'000;
  std::size_t triangles = max_mesh_triangles;
};

/// Triangles, strips and fans, in the scene; fronts stay in front where the transform mirrors. Colours are COLOR_0
/// without alpha, none where it is missing.
/// \throws Error (bad_data) at the place.
PlainMesh primitive_mesh(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const PrimitivePose& pose,
                         const MeshRoom& room, const GltfPlace& place);

}  // namespace pomona
