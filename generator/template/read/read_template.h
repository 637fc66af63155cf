// From a template's TOML to a Template, every error with file, line and column.
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

/// A template and how its drawing lies: what those need who show both at one place.
struct DrawnTemplate {
  Template fruit;

  /// From the drawing to metres of the fruit: of the side view distance from the axis and height; of the top view +X
  /// and -Z. In units of the page for a sketch, of the template for curves that it holds itself. Nothing where a
  /// sketch lacks the view.
  std::optional<SvgTransform> side, top;
};

/// The same with `svg` for the sketch that the template names, whatever lies on disk. \throws Error as above
DrawnTemplate parse_drawn_template(std::string_view toml, const std::string& file, std::optional<std::string_view> svg);

/// The same from disk. \throws Error (input_missing) if it cannot be read.
Template read_template(const std::filesystem::path& file);

}  // namespace pomona
