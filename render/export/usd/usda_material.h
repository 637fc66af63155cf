// Materials of a USD file.
#pragma once

#include <map>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "render/export/pbr_material.h"
#include "render/export/usd/usda_text.h"

namespace pomona::usd {

/// A variant of the set "ripeness": its name, and the file with the colours.
struct TextureChoice {
  std::string name, file;
};

/// "def Material NAME": the look's class prim, with a texture's colours instead of those of vertices. \param file of
/// the texture; empty if variants name it, because a prim's own value wins over its variants.
void append_textured_material(std::string& text, int indent, const std::string& name, const std::string& look,
                              const std::string& file);

/// The variant set: each choice names the file of these materials in the piece's scope "Looks".
void append_texture_choices(std::string& text, int indent, std::span<const TextureChoice> choices,
                            std::span<const std::string> materials);

/// The looks that all pieces of a fruit share: a class prim for each, to which pieces refer.
class Looks {
 public:
  /// The name of the class for one of the solid's groups: "tomato_skin".
  std::string name_for(const Solid& solid, const MaterialGroup& group);

  /// The class prims: UsdPreviewSurface, and OpenPBR for renderers that know MaterialX, coloured by displayColor.
  std::string text() const { return text_; }

 private:
  PrimNames names_;
  std::map<std::tuple<std::string, float, PbrMaterial>, std::string> known_;
  std::string text_;
};

}  // namespace pomona::usd
