// Strokes and profiles of knives from SVG files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "generator/base/curve.h"

namespace pomona {

/// The open path with this id (or Inkscape label), in metres, y upwards. The SVG's origin becomes that of the frame.
/// Curves are flattened with an error of a hundredth of a millimetre. \param scale metres per SVG unit. \throws Error
/// (input_missing, bad_data) that names the file and the place in it.
std::vector<glm::dvec2> read_stroke(const std::filesystem::path& file, const std::string& id, double scale);

/// The same for a profile of revolution around the SVG's y axis: x is the distance from the axis. The profile is open,
/// or closed and beside the axis. It does not cross itself; only the ends of an open profile may touch the axis.
Curve read_profile(const std::filesystem::path& file, const std::string& id, double scale);

/// Both from the text of an SVG; `file` is its name in messages.
std::vector<glm::dvec2> parse_stroke(std::string_view svg, const std::string& file, const std::string& id,
                                     double scale);
Curve parse_profile(std::string_view svg, const std::string& file, const std::string& id, double scale);

}  // namespace pomona
