// A fruit to start from: an SVG with its layers in place, and the template that takes its curves from it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <glm/vec2.hpp>

namespace pomona {

/// A picture to draw over, linked from the SVG.
struct SketchPicture {
  std::string href;    ///< relative to the SVG, as it is to stand in it
  glm::dvec2 size{1};  ///< pixels
};

struct StartingSketchOptions {
  std::string name;                   ///< of the fruit; a-z 0-9 - _
  std::optional<int> folds = {};      ///< 1..64; none: cylindrical
  std::optional<SketchPicture> side;  ///< under the side view; colours are taken from it
  std::optional<SketchPicture> top;   ///< under the top view
};

struct StartingSketch {
  std::string svg;   ///< to be written as NAME.svg
  std::string toml;  ///< beside it
};

/// Curves of a made-up fruit 60 mm wide that can be checked, grown and cut as they are.
StartingSketch starting_sketch(const StartingSketchOptions& options);

/// A fruit's name, from that of the template to be. \throws Error (usage) where it is no plain name, or ends otherwise
std::string fruit_name(const std::filesystem::path& file);

}  // namespace pomona
