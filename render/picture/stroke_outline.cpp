#include "render/picture/stroke_outline.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace pomona {

namespace {

constexpr double tolerance = 0.2;  // pixels

std::string place_text(const glm::dvec2& p) { return hundredths(p.x) + "," + hundredths(p.y); }

/// The distance of a point of the stroke from the straight stroke from `a` to `b`, width included.
double off_straight(const StrokePoint& a, const StrokePoint& b, const StrokePoint& p) {
  const glm::dvec3 from(a.at, a.radius), along = glm::dvec3(b.at, b.radius) - from;
  const glm::dvec3 to = glm::dvec3(p.at, p.radius) - from;
  const double squared = glm::dot(along, along);
  const double t = squared > 0 ? std::clamp(glm::dot(to, along) / squared, 0.0, 1.0) : 0.0;
  return glm::length(to - along * t);
}

/// The points that become nodes [Douglas & Peucker 1973]; straight lines between them may differ by four times the
/// tolerance, which curves between them make up for.
std::vector<std::size_t> nodes_worth(const std::vector<StrokePoint>& stroke) {
  // Both ends are nodes; in each span, so is the farthest point, if it is far enough.
  std::vector<std::uint8_t> worth(stroke.size(), 0);
  worth.front() = worth.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> spans{{0, stroke.size() - 1}};
  while (!spans.empty()) {
    const auto [first, last] = spans.back();
    spans.pop_back();
    double max = 4 * tolerance;
    std::size_t at = 0;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = off_straight(stroke[first], stroke[last], stroke[i]);
      if (off > max) max = off, at = i;
    }
    if (at == 0) continue;
    worth[at] = 1;
    spans.insert(spans.end(), {{first, at}, {at, last}});
  }

  // The nodes in the stroke's order.
  std::vector<std::size_t> nodes;
  for (std::size_t i = 0; i < worth.size(); ++i) {
    if (worth[i] != 0) nodes.push_back(i);
  }
  return nodes;
}

std::vector<glm::dvec2> side_of(const std::vector<StrokePoint>& stroke, double side) {
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < stroke.size(); ++i) {
    const glm::dvec2 d = stroke[std::min(i + 1, stroke.size() - 1)].at - stroke[i > 0 ? i - 1 : 0].at;
    const double size = glm::length(d);
    const glm::dvec2 normal = size > 0 ? glm::dvec2(-d.y, d.x) / size : glm::dvec2(0);
    points.push_back(stroke[i].at + normal * (side * stroke[i].radius));
  }
  return points;
}

glm::dvec2 direction_at(const std::vector<glm::dvec2>& points, std::size_t i) {
  const glm::dvec2 d = points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0];
  const double size = glm::length(d);
  return size > 0 ? d / size : glm::dvec2(0);
}

/// Cubic curves through the nodes, in the points' order; the pen stands on the first.
std::string curves(const std::vector<glm::dvec2>& points, const std::vector<std::size_t>& nodes) {
  std::string text = "C";
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    const std::size_t a = nodes[k - 1], b = nodes[k];
    double length = 0;
    for (std::size_t i = a; i < b; ++i) length += glm::distance(points[i], points[i + 1]);
    text += " " + place_text(points[a] + direction_at(points, a) * (length / 3));
    text += " " + place_text(points[b] - direction_at(points, b) * (length / 3)) + " " + place_text(points[b]);
  }
  return text;
}

std::string round_end(double radius, const glm::dvec2& to) {
  return "A" + hundredths(radius) + "," + hundredths(radius) + " 0 0 0 " + place_text(to);
}

}  // namespace

std::string hundredths(double number) {
  const double rounded = std::floor(number * 100 + 0.5) / 100;
  std::array<char, 48> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), rounded == 0 ? 0.0 : rounded, std::chars_format::fixed, 2);
  std::string result(text.data(), error == std::errc() ? end : text.data());
  while (result.ends_with('0')) result.pop_back();
  if (result.ends_with('.')) result.pop_back();
  return result;
}

std::string stroke_outline(const std::vector<StrokePoint>& stroke) {
  if (stroke.size() < 2) return {};
  std::vector<std::size_t> nodes = nodes_worth(stroke);
  std::vector<glm::dvec2> there = side_of(stroke, 1), back = side_of(stroke, -1);
  std::string text = "M" + place_text(there.front()) + curves(there, nodes);
  text += round_end(stroke.back().radius, back.back());

  std::reverse(back.begin(), back.end());
  std::reverse(nodes.begin(), nodes.end());
  for (std::size_t& node : nodes) node = stroke.size() - 1 - node;
  text += curves(back, nodes);
  return text + round_end(stroke.front().radius, there.front()) + "Z";
}

}  // namespace pomona
