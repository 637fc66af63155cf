// A textured .glb, read and drawn flat, equals the picture of the section.
#include <gtest/gtest.h>
#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/order/order.h"
#include "generator/scene/scene.h"
#include "render/export/gltf/write_glb.h"
#include "render/image/triangle_raster.h"
#include "render/picture/section_layout.h"
#include "render/picture/section_picture.h"
#include "render/style/style_file.h"
#include "tests/render/export/read_glb.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

constexpr int side = 256;

/// The halves of a seeded fruit, with a section of any fineness.
struct Halves {
  DiffusionSurfaces surfaces = shapes::seeded_fruit();
  Template fruit;
  std::unique_ptr<Diffuser> diffuser = make_pmvc_diffuser({.quality = Quality::final, .threads = {}});
  std::vector<Knife> knives{parse_knife("half")};

  Halves() {
    fruit.parts = surfaces.part_names;
    fruit.noise.base_frequency = 100;
    fruit.noise.keys.push_back({.color = {0.5f, 0.5f, 0.2f}, .weights = {0.05, 0.04}, .axis = {1, 0, 0}});
  }

  CrossSection section(const CutOptions& options) const {
    return colored(cut(surfaces, knives, options).section, surfaces, *diffuser);
  }

  /// Without an origin, so that files keep the fruit's frame.
  Scene pieces() const {
    Scene scene =
        gathered(shapes::sliced(surfaces, knives, fruit, diffuser.get(), {.keep_section_colors = true}).pieces);
    for (Solid& solid : scene.solids) solid.origin = {};
    return scene;
  }
};

/// Level 0 of a texture in linear light, interpolated as by a graphics card.
Color looked_up(const named::GlbMesh& mesh, const glm::dvec2& uv) {
  const int height = static_cast<int>(mesh.texture.size()) / mesh.texture_side;
  const glm::dvec2 at = uv * glm::dvec2(mesh.texture_side, height) - 0.5;
  const glm::ivec2 low(glm::floor(at));
  const glm::vec2 f(at - glm::dvec2(low));
  const auto texel = [&](int dx, int dy) {
    const int x = std::clamp(low.x + dx, 0, mesh.texture_side - 1), y = std::clamp(low.y + dy, 0, height - 1);
    return from_srgb8(mesh.texture[static_cast<std::size_t>(y) * mesh.texture_side + x]);
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), f.x), glm::mix(texel(0, 1), texel(1, 1), f.x), f.y);
}

struct Pixel {
  glm::dvec3 sum{0};
  int samples = 0;
};

bool lies_on(const PlacedFace& face, const glm::dvec3& toward, const named::GlbMesh& mesh, const glm::uvec3& t) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(glm::dot(glm::dvec3(mesh.position[t[k]]) - face.depth, toward)) > 1e-7) return false;
  }
  return glm::dot(glm::dvec3(mesh.normal[t.x]), toward) > 0.999;
}

/// All triangles of the file that lie on the section and face the same way, with 4 x 4 samples per pixel.
std::vector<Pixel> drawn_flat(const named::Glb& glb, const PlacedFace& face) {
  const glm::dvec3 toward = glm::cross(face.right, face.up);
  std::vector<Pixel> pixels(static_cast<std::size_t>(side) * side);
  for (const named::GlbMesh& mesh : glb.meshes) {
    for (const glm::uvec3& t : mesh.triangle) {
      if (!lies_on(face, toward, mesh, t)) continue;
      std::array<glm::dvec2, 3> p;
      for (int k = 0; k < 3; ++k) p[static_cast<std::size_t>(k)] = face.to_paper(mesh.position[t[k]]);
      const glm::dvec2 b = p[1] - p[0], c = p[2] - p[0];
      const double area = b.x * c.y - b.y * c.x;
      const glm::ivec2 low(glm::floor(glm::min(p[0], glm::min(p[1], p[2])))),
          high(glm::floor(glm::max(p[0], glm::max(p[1], p[2]))));
      for (int y = low.y; y <= high.y; ++y) {
        for (int x = low.x; x <= high.x; ++x) {
          for (int s = 0; s < 16; ++s) {
            const glm::dvec2 q = glm::dvec2(x + (s % 4 + 0.5) / 4, y + (s / 4 + 0.5) / 4) - p[0];
            const double u = (q.x * c.y - q.y * c.x) / area, v = (b.x * q.y - b.y * q.x) / area;
            if (!(u >= 0 && v >= 0 && u + v <= 1)) continue;
            const glm::dvec2 uv =
                glm::dvec2(mesh.uv[t.x]) * (1 - u - v) + glm::dvec2(mesh.uv[t.y]) * u + glm::dvec2(mesh.uv[t.z]) * v;
            Pixel& pixel = pixels[static_cast<std::size_t>(y) * side + x];
            pixel.sum += glm::dvec3(looked_up(mesh, uv));
            ++pixel.samples;
          }
        }
      }
    }
  }
  return pixels;
}

/// Root of the mean squared difference in units of 255 over the pixels that the face covers.
double rms(const std::vector<Pixel>& pixels, const Image& picture) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (pixels[i].samples < 16) continue;
    const glm::dvec3 d = glm::dvec3(to_srgb8(Color(pixels[i].sum / static_cast<double>(pixels[i].samples)))) -
                         glm::dvec3(picture.pixels[i]);
    sum += glm::dot(d, d) / 3;
    ++count;
  }
  EXPECT_GT(count, side * side / 4);
  return std::sqrt(sum / count);
}

double difference_in(const Style& style) {
  const Halves halves;
  const CrossSection fine = halves.section({.coarsest = 1 / 150., .finest = 1 / 600., .contrast = 4 / 255.});
  SectionPictureOptions options;
  options.width = options.height = side;
  const Image picture = draw_section(fine, {halves.fruit.noise}, halves.fruit.ink, style, options);
  Scene scene = halves.pieces();
  scene.solids.resize(1), scene.instances.resize(1);  // the half that faces as in the picture
  const std::vector<BakedSolid> textured = all_baked(scene.solids, style, {.texels = 1024});
  const named::Glb glb = named::read_glb(write_glb(scene, textured));
  const double difference = rms(drawn_flat(glb, lay_out(fine, {side, side}, 0.05 * side).front()), picture);
  ::testing::Test::RecordProperty(style.name, std::to_string(difference));
  return difference;
}

TEST(TexturedGlb, LooksLikeThePictureOfTheSection) {
  EXPECT_LT(difference_in(style_named("plain")), 1.0) << "of 255, RMS";
}

TEST(TexturedGlb, HasTheInkOfThePicture) { EXPECT_LT(difference_in(style_named("ink")), 2.5) << "of 255, RMS"; }

/// Statistics of the texels on flat cut faces: lightness, 0..1, within two texels of the rim and elsewhere.
struct FaceTexels {
  std::vector<double> at_rim;
  double darkest_inside = 1;  ///< of the others
};
FaceTexels face_texels(const BakedSolid& baked) {
  const int texels = baked.texture.width;
  const auto number = [&](int x, int y) { return static_cast<std::size_t>(y) * texels + x; };
  std::vector<char> on_face(number(0, baked.texture.height), 0);
  for (std::size_t t = 0; t < baked.solid.mesh.triangle.size(); ++t) {
    if (baked.solid.mesh.cut_face[t] < 0) continue;
    const glm::uvec3& v = baked.solid.mesh.triangle[t];
    const auto at = [&](std::uint32_t k) { return glm::dvec2(baked.uv[k]) * glm::dvec2(texels, baked.texture.height); };
    TriangleRaster<double>(at(v.x), at(v.y), at(v.z))
        .for_covered({0.5, 1, {0, 0, texels - 1, baked.texture.height - 1}},
                     [&](int x, int y, const glm::dvec3&) { on_face[number(x, y)] = 1; });
  }
  FaceTexels found;
  for (int y = 2; y < baked.texture.height - 2; ++y) {
    for (int x = 2; x < texels - 2; ++x) {
      int around = 0;
      for (int k = 0; k < 25; ++k) around += on_face[number(x - 2 + k % 5, y - 2 + k / 5)];
      if (around == 0) continue;
      const Color color = from_srgb8(baked.texture.at(x, y));
      const double light = 0.2126 * static_cast<double>(color.r) + 0.7152 * static_cast<double>(color.g) +
                           0.0722 * static_cast<double>(color.b);
      if (around < 25) {
        found.at_rim.push_back(light);
      } else {
        found.darkest_inside = std::min(found.darkest_inside, light);
      }
    }
  }
  return found;
}

/// The share of texels along the rims that are darker than everything on both sides.
double dark_at_rim(const Style& style) {
  Halves halves;  // owns the diffuser that the textures use
  const Scene scene = halves.pieces();
  double darkest_skin = 1;
  const Solid& half = scene.solids.front();
  for (std::size_t t = 0; t < half.mesh.triangle.size(); ++t) {
    const Color& color = half.mesh.color[half.mesh.triangle[t].x];
    if (half.mesh.cut_face[t] >= 0) continue;
    darkest_skin =
        std::min(darkest_skin, 0.2126 * static_cast<double>(color.r) + 0.7152 * static_cast<double>(color.g) +
                                   0.0722 * static_cast<double>(color.b));
  }
  const FaceTexels texels = face_texels(baked(half, style, {.texels = 256}));
  EXPECT_GT(texels.at_rim.size(), 300u);
  const double darkest = std::min(darkest_skin, texels.darkest_inside) - 2 / 255.;
  const auto dark = std::count_if(texels.at_rim.begin(), texels.at_rim.end(), [&](double l) { return l < darkest; });
  return static_cast<double>(dark) / static_cast<double>(texels.at_rim.size());
}

TEST(TexturedGlb, HasNoDarkLineAlongTheRimOfACutUnlessInkIsAskedFor) {
  EXPECT_EQ(dark_at_rim(style_named(baked_style({}))), 0);
  EXPECT_GT(dark_at_rim(style_named("ink")), 0.05) << "the measure sees a line";
}

TEST(TexturedGlb, HasThePaintOfThePicture) {
  Style style = style_named("plain");
  style.name = "paint";
  style.noise = true;
  style.saturation = 0.4;
  style.lightness = 0.07;
  EXPECT_LT(difference_in(style), 1.0) << "of 255, RMS";
}

/// In the middles of triangles larger than a few texels, of a bowl and of the ball cut from it, the texture has the
/// diffused colour.
TEST(TexturedGlb, CurvedFacesHaveTheColoursOfTheirPlaces) {
  const glm::dvec3 center(0.028, 0.006, 0.01);
  const double radius = 0.02;
  Halves halves;
  halves.knives = {parse_knife("ball:40mm,at=28mm,6mm,10mm")};
  const Scene scene = halves.pieces();
  ASSERT_EQ(scene.solids.size(), 2u);
  const std::vector<BakedSolid> textured = all_baked(scene.solids, style_named("plain"), {.texels = 1024});
  const double texel = std::max(textured[0].texel, textured[1].texel);
  const named::Glb glb = named::read_glb(write_glb(scene, textured));
  const std::unique_ptr<ColorField> field = halves.diffuser->field(halves.surfaces);
  for (const named::GlbMesh& mesh : glb.meshes) {
    std::vector<glm::vec3> middle;
    std::vector<Color> seen;
    for (const glm::uvec3& t : mesh.triangle) {
      bool on_ball = true;
      for (int k = 0; k < 3; ++k) {
        on_ball = on_ball && std::abs(glm::distance(glm::dvec3(mesh.position[t[k]]), center) - radius) < 1e-4;
      }
      const glm::dvec3 a(mesh.position[t.x]), b(mesh.position[t.y]), c(mesh.position[t.z]);
      if (!on_ball || 0.5 * glm::length(glm::cross(b - a, c - a)) < 4 * texel * texel) continue;
      middle.push_back((mesh.position[t.x] + mesh.position[t.y] + mesh.position[t.z]) / 3.0f);
      seen.push_back(looked_up(mesh, glm::dvec2(mesh.uv[t.x] + mesh.uv[t.y] + mesh.uv[t.z]) / 3.0));
    }
    EXPECT_GT(middle.size(), 1000u);
    const DiffusedColors there = field->at(middle);
    double sum = 0;
    for (std::size_t i = 0; i < middle.size(); ++i) {
      const glm::dvec3 d = glm::dvec3(to_srgb8(seen[i])) - glm::dvec3(to_srgb8(there.color[i]));
      sum += glm::dot(d, d) / 3;
    }
    EXPECT_LT(std::sqrt(sum / static_cast<double>(middle.size())), 1.0) << mesh.name;
  }
}

TEST(TexturedGlb, SaysHowTexturesAreLookedUp) {
  const Halves halves;
  const Scene scene = halves.pieces();
  const named::Glb glb =
      named::read_glb(write_glb(scene, all_baked(scene.solids, style_named("plain"), {.texels = 64})));
  for (const named::GlbMesh& mesh : glb.meshes) EXPECT_TRUE(mesh.color.empty()) << "vertex colours would count twice";
}

}  // namespace
}  // namespace pomona
