#include "render/export/styled_mesh.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

StyledMesh styled(const Solid& solid, const Style& style = {}) {
  Scene scene;
  scene.solids = {solid};
  return styled_meshes(scene, {.style = style})[0];
}

Style without_noise() {
  Style style;
  style.noise = false;
  return style;
}

Solid speckled_ball() {
  Solid ball = named::ball("ball", 0.05f, 24, {0.5f, 0.4f, 0.1f});
  ball.own_look().noise.base_frequency = 40;
  ball.own_look().noise.keys = {{ball.mesh.color[0], {0.1, 0.1}, {1, 0, 0}}};
  return ball;
}

TEST(StyledMesh, WeldsWhatIsEqualAndNothingElse) {
  // A box has four vertices of its own on each face; all of them differ in position, normal or part.
  const Solid box = named::box("box", {0, 0, 0}, {1, 1, 1}, Color(0.5f), Color(0.9f));
  EXPECT_EQ(styled(box).position.size(), 24u);

  Solid soup = box;
  soup.mesh.position.clear(), soup.mesh.normal.clear(), soup.mesh.color.clear(), soup.mesh.part.clear();
  for (glm::uvec3& t : soup.mesh.triangle) {
    for (int k = 0; k < 3; ++k) {
      soup.mesh.position.push_back(box.mesh.position[t[k]]);
      soup.mesh.normal.push_back(box.mesh.normal[t[k]]);
      soup.mesh.color.push_back(box.mesh.color[t[k]]);
      soup.mesh.part.push_back(box.mesh.part[t[k]]);
      t[k] = static_cast<std::uint32_t>(soup.mesh.position.size()) - 1;
    }
  }
  EXPECT_EQ(styled(soup).position.size(), 24u);
  EXPECT_EQ(styled(soup).triangle, styled(box).triangle);
}

TEST(StyledMesh, NoiseChangesColoursAndNothingElse) {
  const Solid ball = speckled_ball();
  const StyledMesh with = styled(ball), without = styled(ball, without_noise());
  ASSERT_EQ(with.position, without.position);
  ASSERT_EQ(with.triangle, without.triangle);
  float largest = 0;
  for (std::size_t v = 0; v < with.color.size(); ++v) {
    largest = std::max(largest, glm::length(with.color[v] - without.color[v]));
    EXPECT_TRUE(glm::all(glm::greaterThanEqual(with.color[v], Color(0))));
    EXPECT_TRUE(glm::all(glm::lessThanEqual(with.color[v], Color(1))));
  }
  EXPECT_GT(largest, 0.02f);
}

TEST(StyledMesh, PaintTakesColourAndAddsLight) {
  Style grey = without_noise();
  grey.saturation = 0;
  grey.lightness = 0.1;
  const Solid ball = speckled_ball();
  const glm::vec3 before = to_oklab(ball.mesh.color[0]);
  for (const Color& color : styled(ball, grey).color) {
    const glm::vec3 lab = to_oklab(color);
    EXPECT_NEAR(lab.x, before.x + 0.1, 1e-4);
    EXPECT_NEAR(lab.y, 0, 1e-4);
    EXPECT_NEAR(lab.z, 0, 1e-4);
  }
  for (const Color& color : styled(ball, without_noise()).color) EXPECT_EQ(color, ball.mesh.color[0]);
}

TEST(StyledMesh, NormalsAreOfUnitLengthWhateverCame) {
  Solid ball = named::ball("ball", 0.05f, 4, Color(0.5f));
  const std::vector<glm::vec3> true_normals = ball.mesh.normal;
  ball.mesh.normal[0] = {0, 0, 0};
  ball.mesh.normal[1] *= 7.0f;
  ball.mesh.normal[2] = glm::vec3(std::numeric_limits<float>::quiet_NaN());
  for (const glm::vec3& normal : styled(ball).normal) EXPECT_NEAR(glm::length(normal), 1, 1e-6);
}

TEST(StyledMesh, TrianglesThatUseAVertexTwiceAreLeftOut) {
  Solid ball = named::ball("ball", 0.05f, 2, Color(0.5f));
  const std::size_t before = styled(ball).triangle.size();
  ball.mesh.triangle.push_back({0, 0, 1});
  ball.mesh.cut_face.push_back(-1);
  EXPECT_EQ(styled(ball).triangle.size(), before);
}

/// A vertex on a seam has two places in the texture.
TEST(StyledMesh, VerticesAtTwoPlacesOfATextureAreTwo) {
  Solid twice = named::leaf("leaf", Color(0.5f));
  twice.mesh.position.insert(twice.mesh.position.end(),
                             {twice.mesh.position[0], twice.mesh.position[1], twice.mesh.position[2]});
  twice.mesh.normal.resize(6, twice.mesh.normal[0]), twice.mesh.color.resize(6, twice.mesh.color[0]),
      twice.mesh.part.resize(6, 0);
  twice.mesh.triangle.push_back({3, 4, 5});
  twice.mesh.cut_face.push_back(-1), twice.mesh.surface.push_back(0);
  const auto vertices = [&](const glm::vec2& apart) {
    BakedSolid baked{.solid = twice, .uv = std::vector<glm::vec2>(6, {0.25f, 0.25f}), .texture = {}};
    for (std::size_t v = 3; v < 6; ++v) baked.uv[v] += apart;
    return textured_mesh(baked).position.size();
  };
  EXPECT_EQ(vertices({0, 0}), 3u);
  EXPECT_EQ(vertices({0.5f, 0}), 6u);
  EXPECT_EQ(vertices({0, 0.5f}), 6u);
}

}  // namespace
}  // namespace pomona
