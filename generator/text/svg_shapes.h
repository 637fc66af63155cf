// The basic shapes of SVG as path data.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace pomona {

/// An element's attribute; empty if it has none of that name.
using SvgAttribute = std::function<std::string_view(const char* name)>;

/// A length in units of the page: "12", "12px", "3mm". Nothing for percentages and other texts.
std::optional<double> parse_svg_length(std::string_view text);

/// The attributes of a basic shape that are lengths.
std::span<const char* const> lengths_of(std::string_view tag);

/// Why one of these lengths cannot be read; empty if all can.
std::string length_fault(std::span<const char* const> names, const SvgAttribute& attribute);

struct SvgShape {
  std::string d;
  std::optional<glm::dvec2> center;
  std::string fault;  ///< why it cannot be read; else empty
};

/// The outline of a path, circle, ellipse, rect, line, polyline or polygon; nothing for other elements and for shapes
/// without a size. Corners of rectangles are rounded as SVG 1.1 says (section 9.2).
std::optional<SvgShape> shape_of(std::string_view tag, const SvgAttribute& attribute);

}  // namespace pomona
