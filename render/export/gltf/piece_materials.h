// Materials of a glTF file: one for each PBR material of a fruit.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "render/export/gltf/gltf_document.h"
#include "render/export/pbr_material.h"
#include "render/image/image.h"
#include "render/image/png.h"
#include "render/texture/bake.h"

namespace pomona::gltf {

/// Textures of one piece, as the document's indices.
struct PieceTextures {
  int color = 0;
  std::optional<int> normal = {}, orm = {}, thickness = {}, film = {};  ///< the last two are one texture

  auto operator<=>(const PieceTextures&) const = default;
};

/// All pieces of a fruit share its materials, named by what they show: "tomato skin", "tomato gel". With textures each
/// texture has its own: "tomato.piece-2 skin".
class PieceMaterials {
 public:
  explicit PieceMaterials(GltfDocument& document) : document_(document) {}

  /// \param group of the solid. \param textures of add_textures(), or nothing where vertices have colours.
  int material(const Solid& solid, const MaterialGroup& group, const std::optional<PieceTextures>& textures);

  /// Its colours, and its maps if it has any.
  PieceTextures add_textures(const BakedSolid& baked);

  /// Adds a picture as PNG in the buffer, sampled trilinearly.
  int add_texture(const std::string& name, const Image& picture, PngValues values = PngValues::srgb);

 private:
  int smooth_sampler();
  void add_maps(Json& material, const PbrMaterial& look, const PieceTextures& textures);
  void add_extensions(Json& material, const PbrMaterial& look);

  GltfDocument& document_;
  std::optional<int> sampler_;
  std::map<std::tuple<std::string, bool, float, PbrMaterial, std::optional<PieceTextures>>, int> known_;
};

}  // namespace pomona::gltf
