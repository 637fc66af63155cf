// Renders what the POV-Ray exporter writes with the real program, in the way docs/reference/formats.md says, and
// looks at the picture.
#include <gmock/gmock.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <glm/geometric.hpp>

#include "render/export/output.h"
#include "render/export/pov.h"
#include "render/image/png.h"
#include "tests/base/temporary_folder.h"
#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

std::string content(const fs::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

/// POV-Ray calls its subsurface light experimental, and says so wherever it is asked for; no other warning is right.
std::string without_experimental(std::string log) {
  const std::string known =
      "Warning: This rendering uses the following experimental feature(s):\n subsurface light transport.";
  if (const std::size_t at = log.find(known); at != std::string::npos) log.erase(at, known.size());
  return log;
}

/// Writes the scene into a folder of its own and runs `povray STEM.pov` there.
Image rendered(const Scene& scene, const std::string& stem, const std::string& options = {}, const Style& style = {}) {
  const TemporaryFolder made;
  const fs::path folder = made.path();
  for (const NamedFile& file : write_pov(scene, stem, {.style = style})) write_whole(folder / file.name, file.bytes);
  const std::string command = "cd '" + folder.string() + "' && povray " + stem + ".pov " + options + " >log 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << content(folder / "log");
  EXPECT_THAT(without_experimental(content(folder / "log")), ::testing::Not(::testing::HasSubstr("Warning:")));
  const Image image = read_png(content(folder / (stem + ".png")), stem + ".png");
  return image;
}

/// Where a point lies in the picture, by the definition of View and nothing of the exporter's.
glm::ivec2 pixel_of(const glm::dvec3& point, const View& view, const Image& image) {
  const glm::dvec3 ahead = glm::normalize(view.target - view.eye);
  const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
  const glm::dvec3 up = glm::cross(right, ahead);
  const glm::dvec3 p = point - view.eye;
  const double per_unit = image.height / 2.0 / std::tan(view.vertical_field / 2) / glm::dot(p, ahead);
  return {static_cast<int>(image.width / 2.0 + glm::dot(p, right) * per_unit),
          static_cast<int>(image.height / 2.0 - glm::dot(p, up) * per_unit)};
}

glm::ivec3 color_at(const Image& image, const glm::ivec2& pixel) { return glm::ivec3(image.at(pixel.x, pixel.y)); }

TEST(PovRay, ShowsEverythingWhereItIsInItsColour) {
  const Scene scene = named::axes_of_balls();
  const Image image = rendered(scene, "axes");
  ASSERT_GT(image.width, image.height);

  // The balls at +X, +Y and +Z are red, green and blue: a mirrored picture would have them elsewhere.
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 center(0);
    center[axis] = 0.1;
    const glm::ivec3 color = color_at(image, pixel_of(center, scene.view, image));
    const int others = std::max(color[(axis + 1) % 3], color[(axis + 2) % 3]);
    EXPECT_GT(color[axis], 120) << axis;
    EXPECT_LT(others, color[axis] / 2) << axis;
  }

  // The paper is the paper's colour, and a ball of 2 cm ends after 2 cm.
  const glm::ivec3 paper(to_srgb8(scene.paper));
  EXPECT_EQ(color_at(image, {0, 0}), paper);
  const View& view = scene.view;
  EXPECT_NE(color_at(image, pixel_of({0, 0.117, 0}, view, image)), paper);
  EXPECT_EQ(color_at(image, pixel_of({0, 0.124, 0}, view, image)), paper);
}

TEST(PovRay, LooksStraightDownWithTheBackOnTop) {
  Scene scene = named::axes_of_balls();
  scene.view.target = {0, 0, 0};
  scene.view.eye = {0, 0.6, 0};
  const Image image = rendered(scene, "down");
  const double per_metre = image.height / 2.0 / std::tan(scene.view.vertical_field / 2) / 0.6;
  const int step = static_cast<int>(0.1 * per_metre);
  const glm::ivec3 red = color_at(image, {image.width / 2 + step, image.height / 2});
  const glm::ivec3 blue = color_at(image, {image.width / 2, image.height / 2 + step});
  EXPECT_GT(red.r, 2 * red.b);
  EXPECT_GT(blue.b, 2 * blue.r);
}

TEST(PovRay, LitWhiteGroundIsPaper) {
  Scene scene = named::axes_of_balls();
  scene.ground = true;
  for (Instance& instance : scene.instances) instance.pose.translation.y += 0.02;
  const Image image = rendered(scene, "ground");
  const glm::ivec3 far_from_shadows = color_at(image, {image.width - 20, image.height - 20});
  const glm::ivec3 paper(to_srgb8(scene.paper));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(far_from_shadows[k], paper[k], 16);
}

TEST(PovRay, ShadowsAreTheStylesWashOnPaperAndLieWhereItsLightThrowsThem) {
  Scene scene;
  scene.solids = {named::ball("ball", 0.02f, 20, Color(0.5f))};
  scene.instances = {{.solid = 0, .pose = {.translation = {0, 0.03, 0}}, .name = "ball"}};
  scene.ground = true;
  scene.view.target = {0, 0, 0};
  scene.view.eye = {0, 0.4, 0.3};
  Style style;
  style.light.azimuth = -1.5707963;  // from the left
  style.light.elevation = 0.7853982;
  style.light.softness = 0.05;
  for (const double strength : {1.0, 0.5}) {
    style.shadow = {Color(0.3f, 0.4f, 0.55f), strength};
    const Image image = rendered(scene, "shadow", "+W320 +H240", style);
    const glm::ivec3 shadow = color_at(image, pixel_of({0.03, 0, 0}, scene.view, image));
    const Color wash = glm::mix(Color(1), style.shadow.color, static_cast<float>(strength));
    const glm::ivec3 expected(to_srgb8(scene.paper * wash)), paper(to_srgb8(scene.paper));
    const glm::ivec3 lit = color_at(image, pixel_of({-0.06, 0, 0}, scene.view, image));
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(shadow[k], expected[k], 5) << strength;
      EXPECT_NEAR(lit[k], paper[k], 5) << strength;
    }
  }
}

TEST(PovRay, LightGoesIntoFleshWhereAsked) {
  const Scene scene = named::with_materials();
  const Image plain = rendered(scene, "materials", "+W64 +H48");
  const Image through = rendered(scene, "materials", "+W64 +H48 Declare=Subsurface=1");
  EXPECT_EQ(plain.at(0, 0), through.at(0, 0));
  int different = 0;
  for (std::size_t i = 0; i < plain.pixels.size(); ++i) different += plain.pixels[i] != through.pixels[i];
  EXPECT_GT(different, 100);
}

TEST(PovRay, RendersOpenAndSeeThroughMeshes) {
  const Image image = rendered(named::mixed(), "mixed");
  EXPECT_EQ(image.width, 800);
}

}  // namespace
}  // namespace pomona
