#include "render/thumbnail/thumbnail.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "render/thumbnail/ground_shadow.h"
#include "render/thumbnail/outlines.h"
#include "render/thumbnail/projection.h"
#include "render/thumbnail/sample_grid.h"
#include "render/thumbnail/vertex_light.h"

namespace pomona {

namespace {

constexpr int oversampling = 4;  ///< samples along a pixel's edge

void draw_instance(const Scene& scene, std::size_t index, std::span<const StyledMesh> meshes, const Style& style,
                   const Projection& projection, SampleGrid& grid) {
  const Instance& instance = scene.instances[index];
  const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
  const StyledMesh& mesh = meshes[static_cast<std::size_t>(instance.solid)];
  const std::vector<Color> colors = lit_colors(mesh, solid, instance.pose, projection.frame(), style.light);

  std::vector<GridCorner> corners(mesh.position.size());
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const glm::dvec3 p = instance.pose.rotation * glm::dvec3(mesh.position[v]) + instance.pose.translation;
    corners[v] = {projection(p), colors[v]};
  }
  for (std::size_t t = 0; t < mesh.triangle.size(); ++t) {
    // Of what is closed, the far side is never seen.
    const GridCorner &a = corners[mesh.triangle[t].x], &b = corners[mesh.triangle[t].y],
                     &c = corners[mesh.triangle[t].z];
    const double turn = (b.at.x - a.at.x) * (c.at.y - a.at.y) - (b.at.y - a.at.y) * (c.at.x - a.at.x);
    if (solid.closed && turn >= 0) continue;
    grid.draw({a, b, c}, owner_of(index, mesh.cut_face[t] >= 0));
  }
}

/// One pixel's light so far: linear, times how much of the pixel it covers.
struct Covered {
  Color color{0};
  float share = 0;
};

/// The mean of a pixel's samples, ink over colour.
Covered pixel_of(const SampleGrid& grid, const std::vector<std::uint32_t>& ink, const std::vector<Color>& ink_colors,
                 int px, int py) {
  constexpr float each = 1.0f / (oversampling * oversampling);
  Covered pixel;
  for (int y = py * oversampling; y < (py + 1) * oversampling; ++y) {
    for (int x = px * oversampling; x < (px + 1) * oversampling; ++x) {
      const std::uint32_t line = ink.empty() ? 0 : ink[grid.index(x, y)];
      if (line == 0 && grid.owner(x, y) == 0) continue;
      const Color color = line != 0 ? ink_colors[instance_of(line)] : grid.color(x, y);
      pixel.color += each * glm::clamp(color, Color(0), Color(1));
      pixel.share += each;
    }
  }
  return pixel;
}

/// What is covered over the shadow, and that over paper if there is some. Straight opacity, as PNG wants it.
void put(const Covered& covered, float shadow, const std::optional<Color>& paper, const Color& shade,
         TransparentImage& result) {
  const float rest = 1 - covered.share;
  if (paper) {
    const Color ground = glm::mix(*paper, *paper * shade, shadow);
    result.image.pixels.push_back(to_srgb8(covered.color + rest * ground));
    result.opacity.push_back(255);
    return;
  }
  // A shadow on an unknown ground is a dark veil.
  const float veil = rest * shadow, opacity = covered.share + veil;
  const Color color = opacity > 0 ? (covered.color + veil * 0.06f * shade) / opacity : Color(0);
  result.image.pixels.push_back(to_srgb8(color));
  result.opacity.push_back(static_cast<std::uint8_t>(255 * std::min(opacity, 1.0f) + 0.5f));
}

/// Shadows fade out towards the picture's edges, where they would be cut off.
float fading(int x, int y, int size) {
  const int from_edge = std::min(std::min(x, y), size - 1 - std::max(x, y));
  return std::min(1.0f, static_cast<float>(from_edge) / (0.08f * static_cast<float>(size)));
}

std::vector<Color> ink_colors(const Scene& scene, const Style& style) {
  std::vector<Color> colors;
  for (const Instance& instance : scene.instances)
    colors.push_back(style.ink_color.value_or(scene.solids[static_cast<std::size_t>(instance.solid)].ink.color));
  return colors;
}

}  // namespace

TransparentImage draw_thumbnail(const Scene& scene, std::span<const StyledMesh> meshes, const Style& style,
                                const ThumbnailOptions& options) {
  if (options.size < 16 || options.size > 1024)
    throw Error(ExitStatus::usage, "a thumbnail has 16 to 1024 pixels along its edges");

  // Everything at sixteen samples a pixel, the shadow at one: it is soft.
  const int side = options.size * oversampling;
  SampleGrid grid(side);
  const Projection projection(scene.view, side);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) draw_instance(scene, i, meshes, style, projection, grid);
  const std::vector<float> shadow = ground_shadow(scene, meshes, style, options.size);

  // Finer lines than a picture's: a thumbnail is looked at from near.
  std::vector<std::uint32_t> ink;
  if (style.ink)
    ink = outlines(grid, {.outer = 0.7 * style.outline_width * side, .rim = 0.4 * style.outline_width * side});
  const std::vector<Color> inks = ink_colors(scene, style);

  TransparentImage result{{options.size, options.size, {}}, {}};
  const std::optional<Color> paper = options.on_paper ? std::optional(style.paper) : std::nullopt;
  for (int y = 0; y < options.size; ++y) {
    for (int x = 0; x < options.size; ++x) {
      const float dark = fading(x, y, options.size) * shadow[static_cast<std::size_t>(y) * options.size + x];
      put(pixel_of(grid, ink, inks, x, y), dark, paper, style.shadow.color, result);
    }
  }
  return result;
}

}  // namespace pomona
