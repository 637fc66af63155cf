#include "generator/text/svg_shapes.h"

#include <algorithm>
#include <array>
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
  return {.d = "M" + in_words(center + x) + arc(radii, center + y) + arc(radii, center - x) + arc(radii, center - y) +
               arc(radii, center + x) + "Z",
          .center = center,
          .fault = {}};
}

SvgShape rectangle(const glm::dvec2& at, const glm::dvec2& size, const glm::dvec2& radii) {
  const glm::dvec2 end = at + size, center = at + 0.5 * size;
  if (radii.x == 0 || radii.y == 0) {
    return {
        .d = "M" + in_words(at) + "H" + number_text(end.x) + "V" + number_text(end.y) + "H" + number_text(at.x) + "Z",
        .center = center,
        .fault = {}};
  }
  return {.d = "M" + in_words({at.x + radii.x, at.y}) + "H" + number_text(end.x - radii.x) +
               arc(radii, {end.x, at.y + radii.y}) + "V" + number_text(end.y - radii.y) +
               arc(radii, {end.x - radii.x, end.y}) + "H" + number_text(at.x + radii.x) +
               arc(radii, {at.x, end.y - radii.y}) + "V" + number_text(at.y + radii.y) +
               arc(radii, {at.x + radii.x, at.y}) + "Z",
          .center = center,
          .fault = {}};
}

/// The radii of a rectangle's corners: one radius stands for both, and each is at most half the side.
glm::dvec2 corner_radii(const SvgAttribute& attribute, const glm::dvec2& size) {
  std::optional<double> x = parse_svg_length(attribute("rx")), y = parse_svg_length(attribute("ry"));
  if (!x) x = y;
  if (!y) y = x;
  return {std::clamp(x.value_or(0), 0.0, 0.5 * size.x), std::clamp(y.value_or(0), 0.0, 0.5 * size.y)};
}

}  // namespace

std::span<const char* const> lengths_of(std::string_view tag) {
  static constexpr std::array circle{"cx", "cy", "r"};
  static constexpr std::array line{"x1", "y1", "x2", "y2"};
  static constexpr std::array ellipse{"cx", "cy", "rx", "ry"};
  static constexpr std::array rect{"x", "y", "width", "height", "rx", "ry"};
  if (tag == "circle") return circle;
  if (tag == "line") return line;
  if (tag == "ellipse") return ellipse;
  return tag == "rect" ? std::span<const char* const>(rect) : std::span<const char* const>();
}

std::string length_fault(std::span<const char* const> names, const SvgAttribute& attribute) {
  for (const char* name : names) {
    const std::string_view text = attribute(name);
    if (text.empty() || text == "auto" || parse_svg_length(text)) continue;
    return "has a length that cannot be read: " + std::string(name) + "=\"" + std::string(text.substr(0, 40)) + "\"";
  }
  return {};
}

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
  if (const std::string fault = length_fault(lengths_of(tag), attribute); !fault.empty())
    return SvgShape{.d = {}, .center = {}, .fault = fault};
  if (tag == "path") {
    // Inkscape also writes a circle as a path, with its centre.
    std::optional<glm::dvec2> center;
    if (attribute("sodipodi:type") == "arc")
      center = {number(attribute, "sodipodi:cx"), number(attribute, "sodipodi:cy")};
    return SvgShape{.d = std::string(attribute("d")), .center = center, .fault = {}};
  }
  if (tag == "polyline" || tag == "polygon") {
    const std::string points(attribute("points"));
    if (points.empty()) return {};
    return SvgShape{.d = "M" + points + (tag == "polygon" ? "Z" : ""), .center = {}, .fault = {}};
  }
  if (tag == "line") {
    const glm::dvec2 from(number(attribute, "x1"), number(attribute, "y1"));
    const glm::dvec2 to(number(attribute, "x2"), number(attribute, "y2"));
    return SvgShape{.d = "M" + in_words(from) + "L" + in_words(to), .center = {}, .fault = {}};
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
