// A fruit to start from: an SVG with layers, and a template with curves from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace pomona {

/// A picture to draw over, linked from the SVG.
struct SketchPicture {
  std::string href;    ///< path relative to the SVG
  glm::dvec2 size{1};  ///< pixels
};

struct StartingSketchOptions {
  std::string name;                   ///< name of the fruit; a-z 0-9 - _
  std::optional<int> folds = {};      ///< 1..64; none: cylindrical
  std::optional<SketchPicture> side;  ///< picture of the side view; colours are taken from it
  std::optional<SketchPicture> top;   ///< picture of the top view
};

struct StartingSketch {
  std::string svg;                                   ///< text of NAME.svg
  std::string toml;                                  ///< text of NAME.toml beside it
  std::vector<std::filesystem::path> examples = {};  ///< pictures to lie beside it under their own names
};

/// Curves of an example fruit, 60 mm wide, that can be checked, grown and cut at once.
StartingSketch starting_sketch(const StartingSketchOptions& options);

/// A fruit's name, from the name of its new template.
/// \throws Error (usage) for an invalid name or another ending
std::string fruit_name(const std::filesystem::path& file);

}  // namespace pomona
