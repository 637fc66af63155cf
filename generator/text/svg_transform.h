// SVG's transform attribute.
#pragma once

#include <optional>
#include <string_view>

#include <glm/vec2.hpp>

namespace pomona {

/// x' = a x + c y + e, y' = b x + d y + f: SVG's matrix(a b c d e f).
struct SvgTransform {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  glm::dvec2 operator()(const glm::dvec2& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
};

/// The transform that applies `inner` first, then `outer`.
SvgTransform operator*(const SvgTransform& outer, const SvgTransform& inner);

SvgTransform translation(const glm::dvec2& by);

/// The inverse; nothing for a transform that flattens the plane.
std::optional<SvgTransform> inverse(const SvgTransform& transform);

/// The largest factor by which it lengthens anything; exactly 1 for the identity.
double largest_stretch(const SvgTransform& transform);

/// A list of matrix, translate, scale, rotate, skewX and skewY (SVG 1.1, section 7.6), applied from the right. Nothing
/// for other texts, or for moves by more than a billion. It does not depend on the locale.
std::optional<SvgTransform> parse_svg_transform(std::string_view text);

}  // namespace pomona
