// Materials of a glTF file: one for each look of a fruit.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include "render/export/gltf/gltf_document.h"
#include "render/export/pbr_look.h"
#include "render/image/image.h"

namespace pomona::gltf {

/// All pieces of a fruit share its materials, named by what they show: "tomato skin", "tomato gel". With textures each
/// texture has its own: "tomato.piece-2 skin".
class PieceMaterials {
 public:
  explicit PieceMaterials(GltfDocument& document) : document_(document) {}

  /// \param look of one of the solid's groups. \param texture of add_texture(), or nothing where vertices have colours.
  int material(const Solid& solid, const LookGroup& group, std::optional<int> texture);

  /// As a PNG in the buffer, looked up trilinearly.
  int add_texture(const std::string& name, const Image& picture);

 private:
  int smooth_sampler();
  void add_extensions(Json& material, const PbrLook& look);

  GltfDocument& document_;
  std::optional<int> sampler_;
  std::map<std::tuple<std::string, bool, float, PbrLook, std::optional<int>>, int> known_;
};

}  // namespace pomona::gltf
