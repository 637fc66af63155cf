// Materials of a glTF file: one for each PBR material of a fruit.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "render/export/gltf/gltf_document.h"
#include "render/export/look_palette.h"
#include "render/export/pbr_material.h"
#include "render/image/image.h"
#include "render/image/png.h"
#include "render/texture/bake.h"

namespace pomona::gltf {

/// Textures of one piece, of a page, or of the palette, as the document's indices.
struct PieceTextures {
  std::optional<int> color = {};
  std::optional<int> normal = {}, orm = {}, thickness = {}, film = {};  ///< the last two are one texture

  // Those that tell looks (SurfaceMaps::tell_looks); `coat` and `specular` are one texture.
  std::optional<int> coat = {}, specular = {}, sheen = {}, light = {};
  bool tell_looks = false;
  bool are_shared = false;  ///< by pieces on a page: their materials, too
  bool is_palette = false;  ///< vertices have colours, and a place on the palette: finish() knows its textures

  auto operator<=>(const PieceTextures&) const = default;
};

/// All pieces of a fruit share its materials, named by what they show: "tomato skin", "tomato gel". With textures each
/// texture has its own: "tomato.piece-2 skin"; where maps tell looks, one: "tomato.piece-2". With a palette a fruit has
/// one, "tomato", or all have one, "looks".
class PieceMaterials {
 public:
  explicit PieceMaterials(GltfDocument& document) : document_(document) {}

  /// \param group of the solid. \param textures of add_textures(), or nothing where vertices have colours.
  int material(const Solid& solid, const MaterialGroup& group, const std::optional<PieceTextures>& textures);

  /// Its colours, and its maps if it has any; those of a page are added once.
  /// \param variant what is added to their names, as " ripeness 0.3".
  PieceTextures add_textures(const BakedSolid& baked, const std::string& variant = {});

  /// What tells the looks of meshes by on_palette().
  LookPalette& palette() { return palette_; }

  /// After all others: the palette's textures, for the materials that take them.
  void finish();

 private:
  int smooth_sampler();
  int add_texture(const std::string& name, const std::string& png);
  void add_look_textures(const std::string& name, const SurfaceMaps& maps, PieceTextures& textures);
  PieceTextures add_all(const std::string& name, const Image& color, const SurfaceMaps& maps, bool is_thin);
  void add_look_maps(Json& material, const PieceTextures& textures);
  void add_maps(Json& material, const PbrMaterial& look, const PieceTextures& textures);
  void add_extensions(Json& material, const PbrMaterial& look);

  GltfDocument& document_;
  std::optional<int> sampler_;
  LookPalette palette_;
  std::vector<int> on_palette_;  ///< materials
  std::map<const TexturePage*, PieceTextures> pages_;
  std::map<std::tuple<std::string, bool, float, PbrMaterial, std::optional<PieceTextures>>, int> known_;
};

}  // namespace pomona::gltf
