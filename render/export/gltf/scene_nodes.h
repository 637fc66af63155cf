// The nodes of a glTF file: pieces at their poses, grouped by fruit, with levels of detail and hulls.
#pragma once

#include <span>
#include <vector>

#include "generator/scene/scene.h"
#include "render/export/gltf/gltf_document.h"
#include "render/export/styled_mesh.h"

namespace pomona::gltf {

/// The meshes of a solid. A solid without triangles has none, because glTF does not allow empty meshes.
struct SolidMeshes {
  std::vector<int> meshes;     ///< meshes of the solid, then of its coarser levels
  std::vector<double> scales;  ///< of the meshes, where they are coded in steps; else empty
  std::vector<int> hulls;      ///< meshes of the convex parts to collide with
  int triangles = -1;          ///< the mesh whose triangles are collided with; -1: none
  double reach = 0;            ///< metres from the pivot to the farthest point
  glm::vec3 pivot{0};          ///< pivot of the solid: the origin of its meshes
};

/// What an instance has in place of its solid's.
struct OwnMeshes {
  int mesh = -1;                ///< the finest; -1: its solid's
  std::vector<int> hulls = {};  ///< to collide with; none: its solid's
};

/// A node per instance or, where options.instances says so, one for all instances of a solid
/// (EXT_mesh_gpu_instancing). Above them a node for each entry of a scene and each fruit that has several pieces;
/// beside them the camera.
/// \param own of each instance
void add_nodes(GltfDocument& document, const Scene& scene, std::span<const SolidMeshes> solids,
               std::span<const OwnMeshes> own, const ExportOptions& options);

}  // namespace pomona::gltf
