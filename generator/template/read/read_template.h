// Reads a Template from TOML; every error has file, line and column.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "generator/template/template.h"
#include "generator/text/svg_transform.h"

namespace pomona {

/// Reads and checks a template. `file` is the name used in messages.
/// \throws Error (bad_data) with all errors, also unknown keys, ordered by position.
Template parse_template(std::string_view toml, const std::string& file);

/// A template and how its drawing lies, for callers that show both at one place.
struct DrawnTemplate {
  Template fruit;

  /// Maps from the drawing to metres of the fruit: the side view to distance from the axis and height, the top view to
  /// +X and -Z. The drawing is in units of the page for a sketch, else in the template's units. Nothing if a sketch
  /// lacks the view.
  std::optional<SvgTransform> side, top;
};

/// The same with `svg` as the sketch that the template names, instead of the file on disk.
/// \throws Error as above
DrawnTemplate parse_drawn_template(std::string_view toml, const std::string& file, std::optional<std::string_view> svg);

/// The same from disk.
/// \throws Error (input_missing) if it cannot be read.
Template read_template(const std::filesystem::path& file);

}  // namespace pomona
