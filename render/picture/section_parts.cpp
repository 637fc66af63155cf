#include "render/picture/section_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "render/image/triangle_raster.h"

namespace pomona {

namespace {

void mark(const std::array<glm::dvec2, 3>& corner, const std::array<std::int32_t, 3>& part, PartMap& map) {
  // Each pixel has the part of the corner with the largest share of its middle.
  const TriangleRaster<double> raster(corner[0], corner[1], corner[2]);
  const RasterSamples<double> middles{0.5, 1, {0, 0, map.width - 1, map.height - 1}};
  raster.for_covered(middles, [&](int x, int y, const glm::dvec3& shares) {
    const std::array<double, 3> share{shares.x / raster.area(), shares.y / raster.area(), shares.z / raster.area()};
    const auto max = std::max_element(share.begin(), share.end()) - share.begin();
    map.part[static_cast<std::size_t>(y) * map.width + x] = part[static_cast<std::size_t>(max)];
  });
}

/// The pixels along a line.
std::vector<std::size_t> pixels_along(const glm::dvec2& a, const glm::dvec2& b, const PartMap& map) {
  const glm::dvec2 d = b - a;
  const int steps = static_cast<int>(4 * std::max(std::fabs(d.x), std::fabs(d.y))) + 1;
  std::vector<std::size_t> pixels;
  for (int i = 0; i <= steps; ++i) {
    const glm::dvec2 p = a + d * (static_cast<double>(i) / steps);
    if (!(p.x >= 0 && p.y >= 0 && p.x < map.width && p.y < map.height)) continue;
    const std::size_t pixel = static_cast<std::size_t>(p.y) * map.width + static_cast<std::size_t>(p.x);
    if (pixels.empty() || pixels.back() != pixel) pixels.push_back(pixel);
  }
  return pixels;
}

/// The pixels of the rim, by the part that is outside there.
using Rims = std::map<std::string, std::set<std::size_t>>;

Rims rims_of(const PartMap& map, const CrossSection& section, const std::vector<PlacedFace>& faces,
             const OutsideParts& outside) {
  // A segment has vertices, whose triangles give the face.
  std::vector<std::int32_t> face_of(section.position.size(), -1);
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    for (int i = 0; i < 3; ++i) face_of[section.triangle[t][i]] = section.cut[t];
  }
  Rims rims;
  for (const SectionSegment& segment : section.segments) {
    const std::int32_t face = face_of[segment.vertex[0]];
    const auto part = outside.find(section.surface_names[segment.surface]);
    if (!segment.boundary || part == outside.end() || face < 0 || !faces[face].shown) continue;
    const std::vector<std::size_t> pixels =
        pixels_along(faces[face].to_paper(section.position[segment.vertex[0]]),
                     faces[face].to_paper(section.position[segment.vertex[1]]), map);
    rims[part->second].insert(pixels.begin(), pixels.end());
  }
  return rims;
}

}  // namespace

void add_rims(PartMap& map, const CrossSection& section, const std::vector<PlacedFace>& faces,
              const OutsideParts& outside) {
  for (const auto& [part, rim] : rims_of(map, section, faces, outside)) {
    auto name = std::find(map.names.begin(), map.names.end(), part);
    if (name == map.names.end()) name = map.names.insert(name, part);
    const auto number = static_cast<std::int32_t>(name - map.names.begin());

    // Parts as thick as a pixel are visible anyway.
    const auto shown = static_cast<std::size_t>(std::count(map.part.begin(), map.part.end(), number));
    if (shown >= rim.size()) continue;
    for (const std::size_t pixel : rim) map.part[pixel] = number;
  }
}

PartMap section_parts(const CrossSection& section, const std::vector<PlacedFace>& faces, int width, int height) {
  PartMap map{width, height, std::vector<std::int32_t>(static_cast<std::size_t>(width) * height, -1),
              section.part_names};
  for (std::size_t t = 0; t < section.triangle.size(); ++t) {
    const PlacedFace& face = faces[section.cut[t]];
    if (!face.shown) continue;
    std::array<glm::dvec2, 3> corner{};
    std::array<std::int32_t, 3> part{};
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t v = section.triangle[t][i];
      corner[static_cast<std::size_t>(i)] = face.to_paper(section.position[v]);
      part[static_cast<std::size_t>(i)] = section.part[v];
    }
    mark(corner, part, map);
  }
  return map;
}

std::vector<std::string> parts_in(const CrossSection& section, const OutsideParts& outside) {
  const std::set<std::int32_t> parts(section.part.begin(), section.part.end());
  std::vector<std::string> names;
  for (const std::int32_t part : parts) {
    if (part >= 0 && part < static_cast<std::int32_t>(section.part_names.size()))
      names.push_back(section.part_names[part]);
  }
  for (const SectionSegment& segment : section.segments) {
    const auto part = outside.find(section.surface_names[segment.surface]);
    if (segment.boundary && part != outside.end() &&
        std::find(names.begin(), names.end(), part->second) == names.end()) {
      names.push_back(part->second);
    }
  }
  return names;
}

}  // namespace pomona
