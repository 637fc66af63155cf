#include "generator/text/svg_shapes.h"

#include <algorithm>
#include <utility>

#include "generator/base/number_text.h"
#include "generator/base/units.h"

namespace pomona {

namespace {

std::string in_words(const glm::dvec2& p) { return number_text(p.x) + " " + number_text(p.y); }

double number(const SvgAttribute& attribute, const char* name) { return parse_svg_length(attribute(name)).value_or(0); }

std::string arc(const glm::dvec2& radii, const glm::dvec2& to) {
  return "A" + in_words(radii) + " 0 0 1 " + in_words(to);
}

/// Four quarters, from the right, downwards first, as in SVG.
SvgShape ellipse(const glm::dvec2& center, const glm::dvec2& radii) {
  const glm::dvec2 x(radii.x, 0), y(0, radii.y);
  return {"M" + in_words(center + x) + arc(radii, center + y) + arc(radii, center - x) + arc(radii, center - y) +
              arc(radii, center + x) + "Z",
          center};
}

SvgShape rectangle(const glm::dvec2& at, const glm::dvec2& size, const glm::dvec2& radii) {
  const glm::dvec2 end = at + size, center = at + 0.5 * size;
  if (radii.x == 0 || radii.y == 0) {
    return {"M" + in_words(at) + "H" + number_text(end.x) + "V" + number_text(end.y) + "H" + number_text(at.x) + "Z",
            center};
  }
  return {"M" + in_words({at.x + radii.x, at.y}) + "H" + number_text(end.x - radii.x) +
              arc(radii, {end.x, at.y + radii.y}) + "V" + number_text(end.y - radii.y) +
              arc(radii, {end.x - radii.x, end.y}) + "H" + number_text(at.x + radii.x) +
              arc(radii, {at.x, end.y - radii.y}) + "V" + number_text(at.y + radii.y) +
              arc(radii, {at.x + radii.x, at.y}) + "Z",
          center};
}

/// The radii of a rectangle's corners: one radius stands for both, and each is at most half the side.
glm::dvec2 corner_radii(const SvgAttribute& attribute, const glm::dvec2& size) {
  std::optional<double> x = parse_svg_length(attribute("rx")), y = parse_svg_length(attribute("ry"));
  if (!x) x = y;
  if (!y) y = x;
  return {std::clamp(x.value_or(0), 0.0, 0.5 * size.x), std::clamp(y.value_or(0), 0.0, 0.5 * size.y)};
}

}  // namespace

std::optional<double> parse_svg_length(std::string_view text) {
  // CSS has 96 pixels per inch.
  constexpr std::pair<std::string_view, double> units[] = {
      {"px", 1}, {"mm", 96 / 25.4}, {"cm", 960 / 25.4}, {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16}, {"Q", 24 / 25.4}};
  double scale = 1;
  for (const auto& [name, pixels] : units) {
    if (!text.ends_with(name)) continue;
    text.remove_suffix(name.size());
    scale = pixels;
    break;
  }
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const std::optional<double> value = parse_number(text);
  if (!value) return {};
  return *value * scale;
}

std::optional<SvgShape> shape_of(std::string_view tag, const SvgAttribute& attribute) {
  if (tag == "path") {
    // Inkscape also writes a circle as a path, with its centre.
    std::optional<glm::dvec2> center;
    if (attribute("sodipodi:type") == "arc")
      center = {number(attribute, "sodipodi:cx"), number(attribute, "sodipodi:cy")};
    return SvgShape{std::string(attribute("d")), center};
  }
  if (tag == "polyline" || tag == "polygon") {
    const std::string points(attribute("points"));
    if (points.empty()) return {};
    return SvgShape{"M" + points + (tag == "polygon" ? "Z" : ""), {}};
  }
  if (tag == "line") {
    const glm::dvec2 from(number(attribute, "x1"), number(attribute, "y1"));
    const glm::dvec2 to(number(attribute, "x2"), number(attribute, "y2"));
    return SvgShape{"M" + in_words(from) + "L" + in_words(to), {}};
  }
  const bool is_circle = tag == "circle";
  if (is_circle || tag == "ellipse") {
    const glm::dvec2 center(number(attribute, "cx"), number(attribute, "cy"));
    const glm::dvec2 radii(number(attribute, is_circle ? "r" : "rx"), number(attribute, is_circle ? "r" : "ry"));
    if (!(radii.x > 0 && radii.y > 0)) return {};
    return ellipse(center, radii);
  }
  if (tag == "rect") {
    const glm::dvec2 at(number(attribute, "x"), number(attribute, "y"));
    const glm::dvec2 size(number(attribute, "width"), number(attribute, "height"));
    if (!(size.x > 0 && size.y > 0)) return {};
    return rectangle(at, size, corner_radii(attribute, size));
  }
  return {};
}

}  // namespace pomona
