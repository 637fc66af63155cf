// Files of meshes: .ply, .obj, .stl, .glb, .usda.
#pragma once

#include <span>
#include <vector>

#include "render/deliver/deliver_options.h"
#include "render/export/texture_variant.h"
#include "render/texture/bake.h"

namespace pomona {

/// Levels of detail and textures, made once for .glb and .usda.
struct ReadyMeshes {
  std::vector<std::vector<Solid>> levels;        ///< levels of each solid; empty without levels of detail
  std::vector<BakedSolid> baked;                 ///< baked solids; empty without textures
  std::vector<std::vector<BakedSolid>> coarser;  ///< their baked levels
  std::vector<TextureVariant> variants;          ///< the solids at other ripenesses
};

/// Levels and textures as ordered. Times, counts and warnings go to `delivered`.
ReadyMeshes ready_meshes(const SceneViews& scene, const Order& order, const DeliverOptions& how, Delivered& delivered);

/// One output of these formats, with the folder of maps if the order names one.
Delivered mesh_files(const Output& output, const SceneViews& scene, const ReadyMeshes& ready, const Order& order,
                     const DeliverOptions& how);

}  // namespace pomona
