// Strokes and profiles of knives from SVG files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"

namespace pomona {

/// The open path with this id (or Inkscape label), in metres, y upwards, the SVG's origin at the frame's; `scale` is
/// the length of one SVG unit. Curves are flattened to a hundredth of a millimetre. \throws Error (input_missing,
/// bad_data) that names the file and the place in it.
std::vector<glm::dvec2> read_stroke(const std::filesystem::path& file, const std::string& id, double scale);

/// In the same way a profile to revolve around the SVG's y axis: x is the distance from it. Open, or closed beside the
/// axis; without crossings, and not on or beyond the axis but with the ends of an open one.
Curve read_profile(const std::filesystem::path& file, const std::string& id, double scale);

/// Both from the text of an SVG; `file` is its name in messages.
std::vector<glm::dvec2> parse_stroke(std::string_view svg, const std::string& file, const std::string& id,
                                     double scale);
Curve parse_profile(std::string_view svg, const std::string& file, const std::string& id, double scale);

}  // namespace pomona
