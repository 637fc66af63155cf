// Transparent solids: layers blended from back to front.
#include "render/gl/glass.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/reproducible.h"
#include "generator/base/units.h"
#include "render/gl/scene_picture.h"
#include "render/style/style_file.h"
#include "tests/render/painted_shapes.h"

namespace pomona {
namespace {

const Color red(0.5f, 0.1f, 0.1f), green(0.1f, 0.4f, 0.15f), blue(0.1f, 0.15f, 0.5f);
const Color black(0), white(1);

/// A square of 20 cm around (0, 0, z), facing the eye or turned about +Y.
Solid pane(double z, const Color& color, float opacity, double turned_degrees = 0) {
  const double turn = radians(turned_degrees);
  const glm::dvec3 across(reproducible::cos(turn), 0, -reproducible::sin(turn));
  const glm::dvec3 normal(reproducible::sin(turn), 0, reproducible::cos(turn));
  Solid solid;
  solid.name = "pane";
  for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    solid.mesh.position.emplace_back(0.1 * (corner.x * across + glm::dvec3(0, corner.y, 0)) + glm::dvec3(0, 0, z));
    solid.mesh.normal.emplace_back(normal);
    solid.mesh.color.push_back(color);
    solid.mesh.part.push_back(0);
  }
  solid.mesh.triangle = {{0, 1, 2}, {0, 2, 3}};
  solid.mesh.cut_face = {-1, -1};
  solid.mesh.surface = {0, 0};
  solid.opacity = opacity;
  solid.closed = false;
  return solid;
}

/// Seen from far away along Z, so that the middle is seen at right angles.
Scene before_paper(std::vector<Solid> solids, const Color& paper) {
  Scene scene = gathered(std::move(solids));
  scene.paper = paper;
  scene.view = {.eye = {0, 0, 2}, .target = {0, 0, 0}, .vertical_field = 0.1};
  return scene;
}

glm::dvec3 middle(const std::vector<Solid>& solids, const Color& paper, int max_layers = 48) {
  const Image image = draw_scene(before_paper(solids, paper), style_named("plain"),
                                 {.width = 33, .height = 33, .max_layers = max_layers});
  const glm::u8vec3 pixel = image.at(16, 16);
  glm::dvec3 linear;
  for (int k = 0; k < 3; ++k) linear[k] = linear_from_srgb(pixel[k] / 255.0);
  return linear;
}

/// The transmittance, measured by the effect of the paper's colour.
double transmittance(const std::vector<Solid>& solids, int max_layers = 48) {
  return (middle(solids, white, max_layers) - middle(solids, black, max_layers)).g;
}

void expect_near(const glm::dvec3& a, const glm::dvec3& b, double max) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(a[k], b[k], max);
}

TEST(Glass, CoversByItsOpacity) {
  for (const float opacity : {0.1f, 0.35f, 0.9f}) {
    EXPECT_NEAR(transmittance({pane(0, green, opacity)}), 1 - opacity, 0.006);
  }
}

TEST(Glass, CoversMoreAtASlantAsAFilmDoes) { EXPECT_NEAR(transmittance({pane(0, green, 0.3f, 60)}), 0.7 * 0.7, 0.006); }

TEST(Glass, LaysLayersOverEachOther) {
  const Solid front = pane(0.02, red, 0.4f), back = pane(-0.02, blue, 0.7f);
  const glm::dvec3 front_alone = middle({front}, black), back_alone = middle({back}, black);
  const double seen = 1 - 0.4;
  expect_near(middle({front, back}, black), front_alone + seen * back_alone, 0.006);
  expect_near(middle({back, front}, black), front_alone + seen * back_alone, 0.006);
  EXPECT_NEAR(transmittance({front, back}), 0.6 * 0.3, 0.006);

  // The reverse order gives another picture.
  EXPECT_GT(
      std::abs(middle({pane(-0.02, red, 0.4f), pane(0.02, blue, 0.7f)}, black).r - middle({front, back}, black).r),
      0.05);
}

TEST(Glass, StandsBeforeWhatIsOpaqueAndNotBehindIt) {
  // The wall is wide enough and the glass far enough that no shadow falls on the measured place.
  Solid wall = pane(0, blue, 1);
  for (glm::vec3& p : wall.mesh.position) p *= 10;
  const glm::dvec3 wall_alone = middle({wall}, black);
  const Solid before = pane(0.6, red, 0.4f), behind = pane(-0.6, red, 0.4f);
  expect_near(middle({wall, before}, black), middle({before}, black) + 0.6 * wall_alone, 0.006);
  expect_near(middle({behind, wall}, black), wall_alone, 0.006);
}

TEST(Glass, ClosedSolidsAreSeenFromOutsideOnly) {
  Solid away = pane(0, red, 0.5f, 180);
  EXPECT_NEAR(transmittance({away}), 0.5, 0.006);
  away.closed = true;
  EXPECT_NEAR(transmittance({away}), 1, 0.001);
}

TEST(Glass, LosesNothingWhereThereAreMoreLayersThanItOrders) {
  std::vector<Solid> panes;
  for (int i = 0; i < 7; ++i) panes.push_back(pane(0.01 * i, green, 0.2f));
  const double all = transmittance(panes);
  EXPECT_NEAR(all, std::pow(0.8, 7), 0.006);
  const glm::dvec3 color = middle(panes, black);
  for (const int max : {1, 6, 7}) {
    EXPECT_NEAR(transmittance(panes, max), all, 0.008) << max;
    expect_near(middle(panes, black, max), color, 0.01);
  }

  // Of different colors the rest is their mean.
  panes = {pane(0.02, red, 0.5f), pane(0, green, 0.5f), pane(-0.02, blue, 0.5f)};
  const glm::dvec3 rest = middle({pane(0, green, 0.5f)}, black) + middle({pane(0, blue, 0.5f)}, black);
  expect_near(middle(panes, black, 1), middle({panes[0]}, black) + 0.5 * 0.75 * rest, 0.008);
}

/// Nested balls, and one that sticks out.
std::vector<Solid> nested_balls() {
  std::vector<Solid> all;
  float number = 0;
  for (const float scale : {1.0f, 0.8f, 0.5f, 0.7f}) {
    Solid ball = testing::ball();
    for (glm::vec3& p : ball.mesh.position) p = scale * p + glm::vec3(number == 3 ? 0.03f : 0.0f, 0.01f * number, 0);
    ball.opacity = 0.15f + 0.2f * number;
    ball.closed = all.size() % 2 == 0;
    all.push_back(std::move(ball));
    number += 1;
  }
  return all;
}

int worst_difference(const Image& a, const Image& b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(int{a.pixels[i][k]} - int{b.pixels[i][k]}));
  }
  return worst;
}

TEST(Glass, DoesNotAskForTheOrderOfTrianglesOrSolids) {
  const PictureOptions options{.width = 120, .height = 120};
  std::vector<Solid> solids = nested_balls();
  const Image plain = draw_scene(gathered(solids), style_named("plain"), options);
  const Image ink = draw_scene(gathered(solids), style_named("ink"), options);
  EXPECT_EQ(draw_scene(gathered(solids), style_named("ink"), options).pixels, ink.pixels) << "drawn once more";

  for (Solid& solid : solids) std::reverse(solid.mesh.triangle.begin(), solid.mesh.triangle.end());
  EXPECT_LE(worst_difference(draw_scene(gathered(solids), style_named("plain"), options), plain), 2);
  EXPECT_LE(worst_difference(draw_scene(gathered(solids), style_named("ink"), options), ink), 2);
  std::reverse(solids.begin(), solids.end());
  EXPECT_LE(worst_difference(draw_scene(gathered(solids), style_named("plain"), options), plain), 2);
}

TEST(Glass, HasContoursInInk) {
  const PictureOptions options{.width = 160, .height = 160};
  std::vector<Solid> solids = nested_balls();
  solids.resize(3);
  const Image plain = draw_scene(gathered(solids), style_named("plain"), options);
  const Image ink = draw_scene(gathered(solids), style_named("ink"), options);
  int darker = 0;
  for (int x = 40; x < 150; ++x)
    darker = std::max(darker, plain.at(x, 80).r - ink.at(x, 80).r);  // inside the outermost ball
  EXPECT_GT(darker, 15);
}

}  // namespace
}  // namespace pomona
