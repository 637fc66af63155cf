#include "render/thumbnail/thumbnail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/piece/pose.h"
#include "render/picture/light_direction.h"
#include "render/picture/view_frame.h"
#include "render/thumbnail/covered_samples.h"
#include "render/thumbnail/projection.h"
#include "render/thumbnail/sample_grid.h"

namespace pomona {

namespace {

/// The shadow per pixel, 0 or 1: everything projected along `towards_light` onto the ground.
std::vector<float> thrown(const Scene& scene, std::span<const StyledMesh> meshes, const Projection& projection,
                          const glm::dvec3& towards_light, int side) {
  std::vector<float> mask(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0.0f);
  for (const Instance& instance : scene.instances) {
    const StyledMesh& mesh = meshes[static_cast<std::size_t>(instance.solid)];
    std::vector<ProjectedPoint> points;
    points.reserve(mesh.position.size());
    for (const glm::vec3& position : mesh.position) {
      const glm::dvec3 p = instance.pose.rotation * glm::dvec3(position) + instance.pose.translation;
      points.push_back(projection(p - towards_light * (p.y / towards_light.y)));
    }
    for (const glm::uvec3& t : mesh.triangle) {
      for_covered_samples({points[t.x], points[t.y], points[t.z]}, side, [&](int x, int y, const glm::dvec3&) {
        mask[static_cast<std::size_t>(y) * side + x] = 1.0f;
      });
    }
  }
  return mask;
}

/// The mean over 2 radius + 1 values of each row, with 0 outside of the picture. Rows become columns.
std::vector<float> averaged_and_turned(const std::vector<float>& values, int side, int radius) {
  std::vector<float> result(values.size());
  const float share = 1.0f / static_cast<float>(2 * radius + 1);
  for (int y = 0; y < side; ++y) {
    const float* row = &values[static_cast<std::size_t>(y) * side];
    float sum = 0;
    for (int x = 0; x < std::min(radius, side); ++x) sum += row[x];
    for (int x = 0; x < side; ++x) {
      if (x + radius < side) sum += row[x + radius];
      if (x - radius - 1 >= 0) sum -= row[x - radius - 1];
      result[static_cast<std::size_t>(x) * side + y] = std::max(0.0f, sum * share);
    }
  }
  return result;
}

/// Three means one after another are nearly a Gaussian.
std::vector<float> softened(std::vector<float> values, int side, int radius) {
  for (int pass = 0; pass < 6; ++pass) values = averaged_and_turned(values, side, radius);
  return values;
}

/// The darkness of the ground y = 0, 0 to 1, for each pixel of a square picture, row by row: the pieces' shadow in the
/// style's light, and a narrow one where they nearly touch the ground. Behind the pieces, too.
std::vector<float> ground_shadow(const Scene& scene, std::span<const StyledMesh> meshes, const Style& style, int side) {
  const Projection projection(scene.view, side);
  const auto radius = [side](double share) { return std::max(1, static_cast<int>(std::lround(share * side))); };

  // The shadow in the light: long, and as soft as the light.
  const glm::dvec3 to_light = light_direction(projection.frame(), style.light.azimuth, style.light.elevation);
  std::vector<float> shadow =
      softened(thrown(scene, meshes, projection, to_light, side), side, radius(0.008 + 0.03 * style.light.softness));

  // The shadow from above: close to the pieces.
  const std::vector<float> contact = softened(thrown(scene, meshes, projection, {0, 1, 0}, side), side, radius(0.012));
  const auto strength = static_cast<float>(style.shadow.strength);
  for (std::size_t i = 0; i < shadow.size(); ++i) {
    const float dark = 1 - (1 - 0.42f * shadow[i]) * (1 - 0.30f * contact[i]);
    shadow[i] = std::clamp(strength * dark, 0.0f, 1.0f);
  }
  return shadow;
}

struct OutlineWidths {
  double outer = 4;  ///< width of lines between and around pieces, samples
  double rim = 3;    ///< width of lines between a cut face and skin
};

/// The identity for outlines().
/// \param instance index into the scene's.
/// \param cut whether it is a cut face.
constexpr std::uint32_t owner_of(std::size_t instance, bool cut) {
  return static_cast<std::uint32_t>(2 * (instance + 1) + (cut ? 1 : 0));
}

constexpr std::size_t instance_of(std::uint32_t owner) { return owner / 2 - 1; }

/// A round nib: the offsets of the samples that it covers.
std::vector<std::pair<int, int>> nib(double width) {
  std::vector<std::pair<int, int>> offsets;
  const double radius = 0.5 * width;
  const int reach = static_cast<int>(std::ceil(radius));
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      if (x * x + y * y <= radius * radius) offsets.emplace_back(x, y);
  return offsets;
}

/// Per sample: the owner whose ink lies there, or 0. An owner is a piece and a kind of face, see owner_of().
std::vector<std::uint32_t> outlines(const SampleGrid& grid, const OutlineWidths& widths) {
  const int side = grid.side();
  std::vector<std::uint32_t> ink(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
  const auto outer = nib(widths.outer), rim = nib(widths.rim);
  const auto draw = [&](int x, int y, std::uint32_t a, std::uint32_t b) {
    // The line belongs to the nearer of the two.
    const bool same_piece = a != 0 && b != 0 && instance_of(a) == instance_of(b);
    for (const auto& [dx, dy] : same_piece ? rim : outer) {
      const int to_x = x + dx, to_y = y + dy;
      if (to_x < 0 || to_y < 0 || to_x >= side || to_y >= side) continue;
      ink[grid.index(to_x, to_y)] = a != 0 ? a : b;
    }
  };

  // Draws wherever two neighbours have different owners.
  for (int y = 0; y + 1 < side; ++y) {
    for (int x = 0; x + 1 < side; ++x) {
      const std::uint32_t here = grid.owner(x, y), right = grid.owner(x + 1, y), below = grid.owner(x, y + 1);
      if (here != right) draw(x, y, here, right);
      if (here != below) draw(x, y, here, below);
    }
  }
  return ink;
}

// The light of pictures that OpenGL draws (shaders/lit.glsl).
const Color sun(0.74f, 0.70f, 0.62f);
const Color sky(0.47f, 0.50f, 0.54f);
const Color bounce(0.40f, 0.36f, 0.31f);
constexpr double highlight = 0.20;  ///< strength of highlights for a gloss of 1

/// Sunlight on a face, soft and wrapped; flatter on cut faces, so that their colours stand out.
double key_light(double cosine, bool cut) {
  const double key = std::clamp((cosine + 0.35) / 1.35, 0.0, 1.0);
  return cut ? 0.55 * key + 0.45 * 0.8 : key;
}

/// x to the 32nd.
double to_32nd(double x) {
  for (int k = 0; k < 5; ++k) x *= x;
  return x;
}

/// The mesh's colours as light of the style's direction and strength shows them, softly: linear, may go above 1 in
/// highlights. Cut faces shine less than skin.
/// \param frame of the viewer.
std::vector<Color> lit_colors(const StyledMesh& mesh, const Solid& solid, const Pose& pose, const ViewFrame& frame,
                              const LightStyle& light) {
  const glm::dvec3 to_light = light_direction(frame, light.azimuth, light.elevation);
  const glm::dvec3 between = glm::normalize(to_light + frame.back);
  std::vector<double> gloss;
  for (std::size_t part = 0; part < solid.look->part_names.size(); ++part)
    gloss.push_back(std::min(material_of(solid, static_cast<std::int32_t>(part)).gloss, 2.0));

  std::vector<Color> lit(mesh.color.size());
  for (std::size_t v = 0; v < lit.size(); ++v) {
    // Light of the sky above, of the table below, and of the sun.
    const glm::dvec3 normal = pose.rotation * glm::dvec3(mesh.normal[v]);
    const bool cut = mesh.face[v] == DetailFace::cut;
    const auto up = static_cast<float>(0.5 + 0.5 * normal.y);
    const Color around = static_cast<float>(light.ambient) * (bounce * (1 - up) + sky * up);
    const double key = light.strength * key_light(glm::dot(normal, to_light), cut);
    lit[v] = mesh.color[v] * (around + static_cast<float>(key) * sun);

    // Only skin shines.
    if (cut) continue;
    const auto part = static_cast<std::size_t>(std::max(mesh.part[v], 0));
    const double shine = part < gloss.size() ? gloss[part] : 1;
    const double mirrored = to_32nd(std::max(0.0, glm::dot(normal, between)));
    lit[v] += Color(static_cast<float>(light.strength * highlight * shine * mirrored));
  }
  return lit;
}

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
    // The far side of closed solids is never visible.
    const GridCorner &a = corners[mesh.triangle[t].x], &b = corners[mesh.triangle[t].y],
                     &c = corners[mesh.triangle[t].z];
    const double turn = (b.at.x - a.at.x) * (c.at.y - a.at.y) - (b.at.y - a.at.y) * (c.at.x - a.at.x);
    if (solid.closed && turn >= 0) continue;
    grid.draw({a, b, c}, owner_of(index, mesh.cut_face[t] >= 0));
  }
}

/// One pixel's light so far, linear, times its coverage.
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

/// Pieces over the shadow, and that over paper if there is some. Opacity is not premultiplied, as in PNG.
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
    colors.push_back(style.ink_color.value_or(scene.solids[static_cast<std::size_t>(instance.solid)].look->ink.color));
  return colors;
}

}  // namespace

TransparentImage draw_thumbnail(const Scene& scene, std::span<const StyledMesh> meshes, const Style& style,
                                const ThumbnailOptions& options) {
  if (options.size < 16 || options.size > 1024)
    throw Error(ExitStatus::usage, "a thumbnail has 16 to 1024 pixels along its edges");

  // Everything has sixteen samples a pixel, but the soft shadow one.
  const int side = options.size * oversampling;
  SampleGrid grid(side);
  const Projection projection(scene.view, side);
  for (std::size_t i = 0; i < scene.instances.size(); ++i) draw_instance(scene, i, meshes, style, projection, grid);
  const std::vector<float> shadow = ground_shadow(scene, meshes, style, options.size);

  // Lines are finer than in a picture, because people look at thumbnails closely.
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
