#include "render/gl/scene_picture.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/cut/section/guide_lattice.h"
#include "render/gl/detail_texels.h"
#include "render/gl/lattice_texels.h"
#include "render/gl/objects.h"
#include "render/gl/program.h"
#include "render/gl/scene_upload.h"
#include "render/style/noise.h"
#include "render/style/relief.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

/// The pixels [red, green, blue, alpha] of a picture that a fragment shader draws.
std::vector<glm::u8vec4> drawn_by(const CurrentGl& gl, const std::string& fragment, const NoiseStyle& noise, int width,
                                  int height, const Look* details = nullptr, const GlTable* lattices = nullptr) {
  const GlTexture picture(gl, GL_RGBA8, width, height);
  const std::array<const GlTexture*, 1> colors{&picture};
  const GlFramebuffer target(gl, colors, nullptr);
  const GlVertexArray nothing(gl);
  const Program program =
      Program::from_sources(gl, shader_source("fullscreen.vert.glsl"), resolved_includes(fragment, "EXAMPLES"));
  program.use();
  const GlBuffer buffer(gl, GL_TEXTURE_BUFFER, noise_texels(noise));
  const GlTexture styles(gl, GL_RGBA32F, buffer);
  const GlBuffer detail_buffer(gl, GL_TEXTURE_BUFFER,
                               all_texels(detail_texels(std::array{details ? *details : Look()})));
  const GlTexture detail_styles(gl, GL_RGBA32F, detail_buffer);
  program.set("noise_styles", 0);
  styles.bind(0);
  program.set("detail_styles", 1);
  detail_styles.bind(1);
  program.set("guide_lattices", 2);
  if (lattices != nullptr) lattices->texture().bind(2);
  target.bind(width, height);
  nothing.bind();
  gl->DrawArrays(GL_TRIANGLES, 0, 3);
  std::vector<glm::u8vec4> pixels(static_cast<std::size_t>(width) * height);
  gl->ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  gl.check("a test picture");
  return pixels;
}

TEST(GlContext, OpensWithoutADisplay) {
  GlContext context;
  EXPECT_FALSE(context.renderer().empty());
  EXPECT_GE(context.version(), 33);
}

TEST(GlContext, TwoLiveInOneProcess) {
  GlContext first, second;
  const Image a = draw_scene(first, testing::ball_scene(), style_named("ink"), {.width = 64, .height = 48});
  const Image b = draw_scene(second, testing::ball_scene(), style_named("ink"), {.width = 64, .height = 48});
  const Image again = draw_scene(first, testing::ball_scene(), style_named("ink"), {.width = 64, .height = 48});
  EXPECT_EQ(a.pixels, b.pixels);
  EXPECT_EQ(a.pixels, again.pixels);
}

TEST(GlContext, TurnsErrorsIntoExceptions) {
  GlContext context;
  const CurrentGl gl(context);
  gl.check("nothing");
  gl->BindTexture(GL_DEPTH_TEST, 0);
  try {
    gl.check("a bad texture target");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("GL_INVALID_ENUM"));
  }
  gl.check("the error has been taken");
}

TEST(GlContext, ReportsShadersThatDoNotCompile) {
  GlContext context;
  const CurrentGl gl(context);
  const std::string vertex = shader_source("fullscreen.vert.glsl");
  EXPECT_THROW(Program::from_sources(gl, vertex, resolved_includes("void main() { nonsense; }")), Error);
  EXPECT_THROW(resolved_includes("#include \"not_there.glsl\"\n"), Error);
}

TEST(Shaders, AllCompile) {
  const std::vector<std::pair<std::string, std::string>> passes{{"solid.vert.glsl", "solid.frag.glsl"},
                                                                {"solid.vert.glsl", "shadow.frag.glsl"},
                                                                {"ground.vert.glsl", "ground.frag.glsl"},
                                                                {"fullscreen.vert.glsl", "light.frag.glsl"},
                                                                {"fullscreen.vert.glsl", "soften.frag.glsl"},
                                                                {"fullscreen.vert.glsl", "through.frag.glsl"},
                                                                {"hair.vert.glsl", "hair.frag.glsl"},
                                                                {"glass.vert.glsl", "glass.frag.glsl"},
                                                                {"fullscreen.vert.glsl", "glass_start.frag.glsl"},
                                                                {"fullscreen.vert.glsl", "glass_layer.frag.glsl"},
                                                                {"fullscreen.vert.glsl", "compose.frag.glsl"}};
  GlContext context;
  const CurrentGl gl(context);
  std::set<std::string> compiled;
  for (const auto& [vertex, fragment] : passes) {
    EXPECT_NO_THROW(Program(gl, vertex, fragment)) << fragment;
    EXPECT_NO_THROW(Program(gl, vertex, fragment, "SEE_THROUGH")) << fragment;
    EXPECT_NO_THROW(Program(gl, vertex, fragment, "ALL_THAT_IS_LEFT")) << fragment;
    EXPECT_NO_THROW(Program(gl, vertex, fragment, "DETAILED")) << fragment;
    EXPECT_NO_THROW(Program(gl, vertex, fragment, "PAPER")) << fragment;
    compiled.insert({vertex, fragment});
  }
  for (const std::string& name : shader_names()) {
    const bool is_stage = name.find(".vert.") != std::string::npos || name.find(".frag.") != std::string::npos;
    EXPECT_TRUE(!is_stage || compiled.contains(name)) << name << " belongs to no pass of this test";
  }
}

TEST(Shaders, NoiseIsThatOfTheCpu) {
  GlContext context;
  const CurrentGl gl(context);
  for (const glm::dvec3& stretch : {glm::dvec3(1), glm::dvec3(0.3, 1, 1), glm::dvec3(1, 0.2, 2)}) {
    NoiseStyle style = testing::some_noise({0.6f, 0.02f, 0.02f});
    style.stretch = stretch;
    style.pattern = stretch.x == 1 ? 0 : max_pattern;
    style.keys.push_back({Color(0.9f, 0.85f, 0.6f), {0.1, 0.1, 0.05}, {0.5, 0.2, -0.3}});
    const std::vector<glm::u8vec4> pixels = drawn_by(gl,
                                                     "#include \"noise.glsl\"\n"
                                                     R"(
out vec4 color;
void main() {
  vec3 p = vec3(gl_FragCoord.x * 0.0011 - 0.0347, 0.0123, gl_FragCoord.y * 0.0009 - 0.0291);
  vec3 plain = mix(vec3(0.6, 0.02, 0.02), vec3(0.9, 0.85, 0.6), gl_FragCoord.x / 64.0);
  color = vec4(srgb_from_linear(modulated(plain, p, 0.0004, 0)), 1.0);
})",
                                                     style, 64, 64);

    // Single precision may differ by a rounding or two.
    const Modulation modulation(style);
    int worst = 0;
    for (int i = 0; i < 64 * 64; ++i) {
      const double x = i % 64 + 0.5, y = i / 64 + 0.5;
      const glm::dvec3 p(x * 0.0011 - 0.0347, 0.0123, y * 0.0009 - 0.0291);
      const Color plain = glm::mix(Color(0.6f, 0.02f, 0.02f), Color(0.9f, 0.85f, 0.6f), static_cast<float>(x / 64));
      const glm::u8vec3 expected = to_srgb8(modulation(plain, p, 0.0004));
      for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(int{pixels[i][k]} - int{expected[k]}));
    }
    EXPECT_LE(worst, 2);
  }
}

/// Noise of 48 texels a side, whose levels are odd in the end.
std::shared_ptr<const ExampleTile> some_tile() {
  const RandomStream stream({3, 0}, "scene_picture_test/tile");
  std::vector<glm::u8vec3> texel;
  for (std::uint64_t i = 0; i < 48 * 48 * 48; ++i)
    texel.emplace_back(100 + 150 * stream.uniform(2 * i), 40 + 200 * stream.uniform(2 * i + 1), 30);
  return std::make_shared<const ExampleTile>(example_tile("noise.png", 48, texel));
}

DetailSketch some_detail(DetailKind kind, DetailRun run) {
  DetailSketch detail;
  detail.kind = kind;
  detail.run = run;
  detail.size = 3e-3, detail.smallest = 1e-3, detail.length = 12e-3;
  detail.wander = 0.3;
  detail.amount = 0.7;
  detail.color = Color(0.9f, 0.85f, 0.6f);
  detail.near = Color(0.6f, 0.02f, 0.02f);
  detail.near_within = 0.4;
  if (kind == DetailKind::example) {
    detail.tile = some_tile();
    detail.color = {};
  }
  return detail;
}

/// The place in a fruit and the plain colour of each of 64 x 64 pixels, for shaders and for the processor.
constexpr const char* detail_places = R"(
#include "detail.glsl"
out vec4 color;
vec3 p = vec3(gl_FragCoord.x * 0.00061 - 0.0247, 0.0123, gl_FragCoord.y * 0.00053 - 0.0191);
vec3 plain = mix(vec3(0.6, 0.02, 0.02), vec3(0.5, 0.3, 0.1), gl_FragCoord.x / 64.0);
vec4 way = vec4(0.3 * p.x, 0.004, 0.3 * p.z, 0.011);
)";

struct DetailPlace {
  Color plain;
  LookPlace place;
};

DetailPlace detail_place(int pixel) {
  const double x = pixel % 64 + 0.5, y = pixel / 64 + 0.5;
  const glm::dvec3 p(x * 0.00061 - 0.0247, 0.0123, y * 0.00053 - 0.0191);
  const DetailGuide guide{glm::vec3(0.3 * p.x, 0.004, 0.3 * p.z), 0.011f, glm::vec4(1)};
  return {glm::mix(Color(0.6f, 0.02f, 0.02f), Color(0.5f, 0.3f, 0.1f), static_cast<float>(x / 64)),
          {.position = p, .footprint = 0.0004, .guide = guide}};
}

TEST(Shaders, DetailIsThatOfTheCpu) {
  GlContext context;
  const CurrentGl gl(context);
  for (const DetailRun run : {DetailRun::none, DetailRun::to_skin, DetailRun::along, DetailRun::around}) {
    for (const DetailKind kind : {DetailKind::fibres, DetailKind::cells, DetailKind::speckles, DetailKind::streaks,
                                  DetailKind::net, DetailKind::example}) {
      DetailSketch darker = some_detail(DetailKind::fibres, run);
      darker.color = {}, darker.amount = -0.1, darker.pattern = max_pattern;
      const Look look(NoiseStyle{}, {darker, some_detail(kind, run)});
      const std::vector<glm::u8vec4> pixels = drawn_by(gl, std::string(detail_places) + R"(
void main() {
  color = vec4(srgb_from_linear(detailed(plain, vec3(0.0), plain, mat3(1.0), p, 0.0004, 0, true, way, vec4(1.0)).color), 1.0);
})",
                                                       NoiseStyle{}, 64, 64, &look);
      int worst = 0, off = 0;
      for (int i = 0; i < 64 * 64; ++i) {
        const DetailPlace at = detail_place(i);
        const glm::u8vec3 expected = to_srgb8(look(at.plain, at.place));
        for (int k = 0; k < 3; ++k) {
          const int apart = std::abs(int{pixels[i][k]} - int{expected[k]});
          worst = std::max(worst, apart);
          off += apart > 2 ? 1 : 0;
        }
      }
      // Of two equally near cells, single precision may choose the other one.
      const bool of_cells = kind == DetailKind::cells;
      EXPECT_LE(off, of_cells ? 8 : 0) << int(kind) << " " << int(run) << " worst " << worst;
    }
  }
}

/// From fine tiles to their mean.
TEST(Shaders, ExamplesAreThoseOfTheCpuAtEveryDistance) {
  GlContext context;
  const CurrentGl gl(context);
  const Look look(NoiseStyle{}, {some_detail(DetailKind::example, DetailRun::to_skin)});
  for (const double footprint : {0.0, 1e-4, 7e-4, 2e-3}) {
    const std::vector<glm::u8vec4> pixels =
        drawn_by(gl, std::string(detail_places) + "const float footprint = " + std::to_string(footprint) + R"(;
void main() {
  color = vec4(srgb_from_linear(detailed(plain, vec3(0.0), plain, mat3(1.0), p, footprint, 0, true, way, vec4(1.0)).color), 1.0);
})",
                 NoiseStyle{}, 64, 64, &look);
    int worst = 0, changed = 0;
    for (int i = 0; i < 64 * 64; ++i) {
      DetailPlace at = detail_place(i);
      at.place.footprint = footprint;
      const glm::u8vec3 expected = to_srgb8(look(at.plain, at.place));
      for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(int{pixels[i][k]} - int{expected[k]}));
      changed += expected == to_srgb8(at.plain) ? 0 : 1;
    }
    EXPECT_LE(worst, 2) << footprint;
    EXPECT_GE(changed, footprint <= 1e-4 ? 2000 : 0) << footprint;
    EXPECT_LE(changed, footprint >= 2e-3 ? 0 : 64 * 64) << footprint;
  }
}

/// Between nodes, at the rim of what is known, and beyond it.
TEST(Shaders, GuidesAreThoseOfTheLattice) {
  const Box<double> box{{-0.03, -0.02, -0.025}, {0.03, 0.04, 0.025}};
  const LatticeFrame frame = lattice_frame(box);
  const std::vector<std::array<glm::dvec3, 3>> triangles{
      {{{-0.02, 0.0123, -0.019}, {0.014, 0.0123, -0.01}, {0, 0.0123, 0.014}}}};
  const std::vector<glm::ivec3> nodes = nodes_around(frame, triangles);
  std::vector<glm::vec4> value;
  for (const glm::ivec3& n : nodes) value.emplace_back(frame.place_of(n), 0.01 + 0.003 * std::cos(n.x + 0.3 * n.z));
  const auto lattice = std::make_shared<const GuideLattice>(frame, nodes, value);
  std::vector<Solid> solids(3);
  solids[1].mesh.guide_lattice = solids[2].mesh.guide_lattice = lattice;

  GlContext context;
  const CurrentGl gl(context);
  const GlTable lattices(gl, GL_RGBA32F, lattice_texels(solids), "guides");
  int known = 0, off = 0;
  for (int solid = 0; solid < 3; ++solid) {
    const std::vector<glm::u8vec4> pixels =
        drawn_by(gl, "#include \"guide_lattice.glsl\"\nconst int solid = " + std::to_string(solid) + R"(;
out vec4 color;
void main() {
  vec3 p = vec3(gl_FragCoord.x * 0.00061 - 0.0247, 0.0123, gl_FragCoord.y * 0.00053 - 0.0191);
  vec4 at = way_layer_at(solid, p, true);
  color = vec4(10.0 * at.xyz + 0.5, 50.0 * at.w);
})",
                 NoiseStyle{}, 64, 64, nullptr, &lattices);
    for (int i = 0; i < 64 * 64; ++i) {
      const std::optional<glm::vec4> found = solid == 0 ? std::nullopt : lattice->at(detail_place(i).place.position);
      const glm::vec4 at = found.value_or(glm::vec4(0));
      known += found ? 1 : 0;
      const glm::vec4 expected = 255.0f * glm::vec4(10.0f * glm::vec3(at) + 0.5f, 50.0f * at.w);
      for (int k = 0; k < 4; ++k) off += std::fabs(static_cast<float>(pixels[i][k]) - expected[k]) > 0.6f ? 1 : 0;
    }
  }
  EXPECT_EQ(off, 0);
  EXPECT_GT(known, 1000);
}

TEST(Shaders, ReliefIsThatOfTheCpu) {
  GlContext context;
  const CurrentGl gl(context);
  const glm::dvec3 normal(0.6, 0.48, 0.64);
  for (const DetailRun run : {DetailRun::none, DetailRun::to_skin, DetailRun::along, DetailRun::around}) {
    for (const DetailKind kind :
         {DetailKind::fibres, DetailKind::cells, DetailKind::speckles, DetailKind::streaks, DetailKind::example}) {
      // Two details of different heights, and between them one with only a colour.
      DetailSketch low = some_detail(DetailKind::fibres, run), high = some_detail(kind, run);
      low.relief = -0.1e-3, low.near = {};
      high.relief = 0.4e-3;
      const Look look(NoiseStyle{}, {low, some_detail(DetailKind::net, run), high});
      const std::vector<glm::u8vec4> pixels = drawn_by(gl, std::string(detail_places) + R"(
void main() {
  vec3 normal = vec3(0.6, 0.48, 0.64);
  color = vec4(0.5 + 0.5 * detailed(plain, normal, plain, mat3(1.0), p, 0.0004, 0, true, way, vec4(1.0)).normal, 1.0);
})",
                                                       NoiseStyle{}, 64, 64, &look);
      int off = 0, tilted_far = 0;
      for (int i = 0; i < 64 * 64; ++i) {
        const DetailPlace at = detail_place(i);
        const Relief relief = relief_at(look, at.plain, at.place, normal);
        const glm::dvec3 expected = 255.0 * (0.5 + 0.5 * tilted(normal, relief.slope));
        bool far = false;
        for (int k = 0; k < 3; ++k) far = far || std::fabs(pixels[i][k] - expected[k]) > 4;
        off += far ? 1 : 0;
        tilted_far += glm::length(relief.slope) > 0.05 ? 1 : 0;
      }
      // If two cells are equally near, or a rim lies between neighbouring places, single precision may choose the other
      // side.
      EXPECT_LE(off, 20) << int(kind) << " " << int(run);
      EXPECT_GT(tilted_far, 200) << int(kind) << " " << int(run);
    }
  }
}

int brightness(const glm::u8vec3& c) { return c.r + c.g + c.b; }

TEST(ScenePicture, ShowsARedBallInInkOnPaper) {
  const Image image = draw_scene(testing::ball_scene(), style_named("ink"), {.width = 320, .height = 240});
  const glm::u8vec3 center = image.at(160, 120);
  EXPECT_GT(center.r, 120);
  EXPECT_LT(center.g, 110);
  EXPECT_GT(brightness(image.at(3, 3)), 600);
  // Somewhere on the outline the line covers a whole pixel.
  int darkest = 765;
  for (int y = 80; y < 160; ++y) {
    for (int x = 0; x < 160; ++x) darkest = std::min(darkest, brightness(image.at(x, y)));
  }
  EXPECT_LT(darkest, 220);
}

TEST(ScenePicture, PlainHasNoInk) {
  const Image image = draw_scene(testing::ball_scene(), style_named("plain"), {.width = 160, .height = 120});
  for (const glm::u8vec3& pixel : image.pixels) EXPECT_GT(brightness(pixel), 90);
}

TEST(ScenePicture, DrawsSceneWithNothingInIt) {
  Scene scene;
  const Image image = draw_scene(scene, style_named("plain"), {.width = 16, .height = 16});
  EXPECT_EQ(image.at(8, 8), to_srgb8(scene.paper));
}

TEST(ScenePicture, CastsAShadowOnTheGround) {
  Scene scene = testing::still_life();
  const PictureOptions options{.width = 200, .height = 150};
  const auto dark = [&](const Image& image) {
    return std::count_if(image.pixels.begin(), image.pixels.end(), [](const glm::u8vec3& c) {
      return brightness(c) < 640 && c.r - c.b < 60;  // grey, not red
    });
  };
  const auto with = dark(draw_scene(scene, style_named("plain"), options));
  scene.ground = false;
  const auto without = dark(draw_scene(scene, style_named("plain"), options));
  EXPECT_GT(with, without + 500);
}

/// More samples soften edges and move nothing: only pixels along outlines change.
TEST(ScenePicture, ShowsTheSameHoweverManySamplesAPixelHas) {
  GlContext context;
  const Scene scene = testing::still_life();
  const auto drawn = [&](int samples) {
    return draw_scene(context, scene, style_named("plain"), {.width = 160, .height = 120, .samples = samples});
  };
  const Image many = drawn(16);
  for (const int samples : {1, 4, 9}) {
    const Image few = drawn(samples);
    std::array<double, 2> mean{};
    int apart = 0;
    for (std::size_t i = 0; i < few.pixels.size(); ++i) {
      mean[0] += brightness(few.pixels[i]);
      mean[1] += brightness(many.pixels[i]);
      apart += std::abs(brightness(few.pixels[i]) - brightness(many.pixels[i])) > 60 ? 1 : 0;
    }
    EXPECT_NEAR(mean[0] / mean[1], 1, 0.01) << samples;
    EXPECT_LT(apart, 0.03 * static_cast<double>(few.pixels.size())) << samples;
  }
}

TEST(ScenePicture, RefusesSizesAndSamplesThatCannotBe) {
  GlContext context;
  const Scene scene = testing::ball_scene();
  const Style style = style_named("plain");
  EXPECT_THROW(draw_scene(context, scene, style, {.width = 0, .height = 10}), Error);
  EXPECT_THROW(draw_scene(context, scene, style, {.width = 10, .height = 1 << 20}), Error);
  EXPECT_THROW(draw_scene(context, scene, style, {.width = 10, .height = 10, .samples = 5}), Error);
}

}  // namespace
}  // namespace pomona
