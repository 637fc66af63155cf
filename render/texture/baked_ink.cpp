#include "render/texture/baked_ink.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <glm/common.hpp>

#include "generator/mesh/edge_map.h"
#include "render/picture/section_strokes.h"

namespace pomona {

namespace {

constexpr double filled = 0.9;  // share of a picture's shorter side that its face takes

/// The chart as a section of one face: at its place in space if it is flat, else flattened in the plane z = 0. Where
/// vertices are doubled along an edge, a surface crosses the face.
CrossSection section_of(const Solid& solid, const Chart& chart) {
  CrossSection section;
  section.faces.resize(1);
  std::map<std::uint32_t, std::uint32_t> number_of;
  EdgeMap<glm::uvec2> edges;                        // the section's vertices at the lower and higher place
  std::map<std::uint32_t, std::uint32_t> first_at;  // a vertex of the section at each place of the chart
  for (std::size_t i = 0; i < chart.triangles.size(); ++i) {
    glm::uvec3 t(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = solid.mesh.triangle[chart.triangles[i]][k];
      const auto [entry, is_new] = number_of.try_emplace(v, static_cast<std::uint32_t>(section.position.size()));
      if (is_new) {
        const glm::dvec2& p = chart.flat[chart.corners[i][k]];
        section.position.push_back(chart.frame ? solid.mesh.position[v] : glm::vec3(p.x, -p.y, 0));
        first_at.try_emplace(chart.corners[i][k], entry->second);
        section.color.push_back(solid.mesh.color[v]);
      }
      t[k] = entry->second;
    }
    section.triangle.push_back(t);
    section.cut.push_back(0);
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = chart.corners[i][k], b = chart.corners[i][(k + 1) % 3];
      glm::uvec2 vertices(t[k], t[(k + 1) % 3]);
      if (a > b) std::swap(vertices.x, vertices.y);
      const auto [first, is_new] = edges.try_emplace({a, b}, vertices);
      if (!is_new && first != vertices) section.segments.push_back({{vertices.x, vertices.y}, 0, false});
    }
  }

  // Adds two triangles without area at a seam: where three meet, there is no rim and no line.
  for (const glm::uvec2& seam : chart.seams) {
    const std::uint32_t a = first_at.at(seam.x), b = first_at.at(seam.y);
    section.triangle.emplace_back(a, b, a);
    section.cut.push_back(0);
  }
  return section;
}

/// The longer side of the largest cut face, metres.
double largest_face(const std::vector<Chart>& charts) {
  double largest = 0;
  for (const Chart& chart : charts) {
    if (chart.cut_face >= 0) largest = std::max({largest, chart.size.x, chart.size.y});
  }
  return largest;
}

}  // namespace

Color BakedInk::over(const Color& color, int x, int y) const {
  const int u = x - low.x, v = y - low.y;
  Color result = color;
  result += (ink - result) * static_cast<float>(inner.at(u, v) * inner_opacity);
  result += (ink - result) * static_cast<float>(rim.at(u, v));
  return result;
}

BakedInk baked_ink(const Solid& solid, const std::vector<Chart>& charts, std::size_t chart, const Atlas& atlas,
                   const Style& style) {
  const Chart& own = charts[chart];
  const glm::ivec2 window(glm::floor(atlas.corner[chart]));
  const glm::ivec2 low = glm::max(window - 2 * atlas.block(), glm::ivec2(0));
  const glm::ivec2 size =
      glm::min(window + glm::ivec2(glm::ceil(own.size * atlas.texels_per_metre)) + 2 * atlas.block() + 1, atlas.size) -
      low;

  PlacedFace face;
  const Chart::Frame frame = own.frame.value_or(Chart::Frame{});
  face.right = frame.right, face.up = frame.up;
  face.low = {frame.origin.x, frame.origin.y - own.size.y};
  face.high = {frame.origin.x + own.size.x, frame.origin.y};
  face.corner = atlas.corner[chart] - glm::dvec2(low);
  face.scale = atlas.texels_per_metre;
  face.shown = true;
  const double side = largest_face(charts) * atlas.texels_per_metre / filled;
  BakedInk drawn{
      {size.x, size.y}, {size.x, size.y}, low, style.ink_color.value_or(solid.look->ink.color), style.inner_opacity};
  for (const SectionStroke& stroke : section_strokes(section_of(solid, own), {face}, solid.look->ink, style, side))
    (stroke.rim ? drawn.rim : drawn.inner).draw(stroke.points);
  return drawn;
}

}  // namespace pomona
