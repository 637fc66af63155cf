// Materials of a piece whose colours are in a texture, and the variant set that chooses among several.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace pomona::usd {

/// A variant of the set "ripeness": its name, and the file with the colours.
struct TextureChoice {
  std::string name, file;
};

/// "def Material NAME": the look's class prim, with the colours of a texture in place of those of vertices. \param file
/// of the texture; empty where variants say it, since what is said here goes before them.
void append_textured_material(std::string& text, int indent, const std::string& name, const std::string& look,
                              const std::string& file);

/// The variant set: each choice names the file of these materials, which lie in the piece's scope "Looks".
void append_texture_choices(std::string& text, int indent, std::span<const TextureChoice> choices,
                            std::span<const std::string> materials);

}  // namespace pomona::usd
