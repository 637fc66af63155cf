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

/// The files of maps in whose place a mesh has its looks (render/texture/maps.h); empty where there is none. Without
/// colours vertices have them.
struct MapFiles {
  std::string color = {}, normal = {}, orm = {}, coat = {}, sheen = {};

  bool tell_looks() const { return !orm.empty(); }
};

/// The looks that all pieces of a fruit share: a class prim for each, to which pieces refer.
class Looks {
 public:
  /// The name of the class for one of the solid's groups: "tomato_skin".
  std::string name_for(const Solid& solid, const MaterialGroup& group);

  /// The name of the class for a group of groups_in_maps(), whose maps are in these files. Nothing of it is physical.
  /// \param wanted its name. \param files that tell no looks: those of the palette, which finish() knows.
  std::string name_for(const std::string& wanted, const MaterialGroup& group, float opacity, const MapFiles& files);

  /// After all others: the classes that take the palette.
  void finish(const MapFiles& of_palette);

  /// The class prims: UsdPreviewSurface, and OpenPBR for renderers that know MaterialX, coloured by displayColor unless
  /// maps have colours.
  std::string text() const { return text_; }

 private:
  struct OnPalette {
    std::string name;
    double clearness = 0;
    float opacity = 1;
  };

  PrimNames names_;
  std::map<std::tuple<std::string, float, PbrMaterial>, std::string> known_;
  std::map<std::tuple<std::string, float, double>, std::string> known_in_maps_;  ///< by the share that goes through
  std::vector<OnPalette> on_palette_;
  std::string text_;
};

}  // namespace pomona::usd
