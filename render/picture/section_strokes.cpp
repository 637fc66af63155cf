#include "render/picture/section_strokes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "render/picture/section_ink.h"

namespace pomona {

namespace {

/// Small faces, as of many slices, get finer lines.
double fineness(const PlacedFace& face, double side) {
  const double size = std::sqrt(glm::dot(face.high - face.low, face.high - face.low)) * face.scale;
  return std::clamp(std::sqrt(size / (0.7 * side)), 0.35, 1.0);
}

/// Short lines, as around a seed, do so, too.
double fineness(const PenLine& line, double side) {
  double length = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const glm::dvec2 d = line.points[i] - line.points[i - 1];
    length += std::sqrt(glm::dot(d, d));
  }
  return std::clamp(std::sqrt(length / (0.3 * side)), 0.3, 1.0);
}

}  // namespace

std::vector<SectionStroke> section_strokes(const CrossSection& section, const std::vector<PlacedFace>& faces,
                                           const InkStyle& ink, const Style& style, double side) {
  std::vector<SectionStroke> strokes;
  for (const SectionLine& line : section_lines(section, faces)) {
    const double fine = fineness(faces[line.face], side) * fineness(line.line, side);
    const double width = side * fine * ink.width * (line.rim ? style.outline_width : style.inner_width);
    const PenOptions pen{.width = width,
                         .wander = line.rim ? 0.3 : 0.4,
                         .wavelength = 0.11 * side * fine,
                         .taper = 0.07 * side * fine,
                         .sway = 0.12 * width};
    strokes.push_back({drawn(line.line, pen), line.face, line.rim});
  }
  return strokes;
}

}  // namespace pomona
