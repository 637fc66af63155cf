// Where glTF puts the points of a mesh: nodes, instances, skins, morph targets.
#pragma once

#include <optional>
#include <vector>

#include <tiny_gltf.h>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "generator/surface/file/gltf_accessors.h"

namespace pomona {

/// The transform of a node within its parent.
/// \throws Error (bad_data) for a rotation that is no unit quaternion.
glm::dmat4 transform_of(const tinygltf::Node& node, const GltfPlace& place);

/// The places of a node's instances (EXT_mesh_gpu_instancing) in the scene; of a node without, its own.
/// \throws Error (bad_data)
std::vector<glm::dmat4> instance_places(const tinygltf::Model& model, const tinygltf::Node& node,
                                        const glm::dmat4& to_scene, const GltfPlace& place);

/// The transform of each joint of a skin, for points of the mesh. `to_scene` has the nodes of the scene.
/// \throws Error (bad_data)
std::vector<glm::dmat4> skin_joints(const tinygltf::Model& model, int skin,
                                    const std::vector<std::optional<glm::dmat4>>& to_scene, const GltfPlace& place);

/// The points with the morph targets added by their weights.
/// \throws Error (bad_data)
std::vector<glm::dvec3> morphed(std::vector<glm::dvec3> position, const tinygltf::Model& model,
                                const tinygltf::Primitive& primitive, const std::vector<double>& weights,
                                const GltfPlace& place);

/// The points in the scene as the joints place them, by their weights.
/// \throws Error (bad_data)
std::vector<glm::dvec3> posed(const std::vector<glm::dvec3>& position, const tinygltf::Model& model,
                              const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
                              const GltfPlace& place);

}  // namespace pomona
