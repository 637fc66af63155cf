// One mesh in the colours of another ripeness.
#include "generator/piece/recolored.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

TEST(Recolored, SkinHasTheOtherFruitsColoursAtItsPlacesAndNothingElseChanges) {
  const DiffusionSurfaces own = shapes::seeded_fruit();
  DiffusionSurfaces other = own;
  for (Color& color : other.front_color) color = Color(1) - color;
  for (Color& color : other.back_color) color = Color(1) - color;
  const std::vector<Solid> pieces = shapes::sliced(own, {parse_knife("half")}).pieces;
  ASSERT_EQ(pieces.size(), 2u);
  const Solid piece = recolored(pieces[0], own, other, {});
  EXPECT_EQ(piece.mesh.position, pieces[0].mesh.position);
  std::size_t skin = 0;
  for (std::size_t t = 0; t < piece.mesh.triangle.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t v = piece.mesh.triangle[t][k];
      if (piece.mesh.cut_face[t] >= 0) continue;
      ++skin;
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(piece.mesh.color[v][channel], 1 - pieces[0].mesh.color[v][channel], 2e-3);
    }
  }
  EXPECT_GT(skin, 1000u);
  const Solid same = recolored(pieces[0], own, own, {});
  for (std::size_t v = 0; v < same.mesh.color.size(); ++v)
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(same.mesh.color[v][channel], pieces[0].mesh.color[v][channel], 2e-3);
}

/// Sides cannot be told by colour: a socket's browned flesh may look more like the stone's coat than like fresh flesh.
TEST(Recolored, TellsTheSidesOfASpareStoneByTheirParts) {
  const Color flesh(0.8f, 0.7f, 0.4f), coat(0.2f, 0.1f, 0.05f), riper(0.9f, 0.4f, 0.2f);
  DiffusionSurfaces own = shapes::nested_spheres(
      0.03, 0.01, 8, shapes::skin_paint(), {.front = flesh, .back = coat, .front_part = "flesh", .back_part = "coat"});
  Template fruit;
  fruit.parts = own.part_names;
  const auto number = [&](const char* part) {
    return static_cast<int>(std::find(fruit.parts.begin(), fruit.parts.end(), part) - fruit.parts.begin());
  };
  fruit.spared = {number("coat")};
  fruit.browning.parts = {{.part = number("flesh"), .color = coat, .rate = 1, .max = 0.9}};
  fruit.individual.browning = 1;
  DiffusionSurfaces other = own;
  for (Color& color : other.front_color)
    if (color == flesh) color = riper;

  const std::vector<Knife> knives{parse_knife("half")};
  std::size_t socket = 0, stone = 0;
  const GrownFruit grown{own, {}, own};
  const Slices halves = slice({grown, fruit, knives, "peach"}, nullptr);
  for (const Solid& half : halves.pieces) {
    const Solid fresh = recolored(half, own, other, {}), old = recolored(half, own, other, fruit);
    for (std::size_t t = 0; t < half.mesh.triangle.size(); ++t) {
      const std::uint32_t v = half.mesh.triangle[t].x;
      if (half.mesh.cut_face[t] >= 0 || glm::length(half.mesh.position[v]) > 0.02f) continue;
      const bool is_socket = half.mesh.part[v] == number("flesh");
      (is_socket ? socket : stone)++;
      for (int channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(fresh.mesh.color[v][channel], (is_socket ? riper : coat)[channel], 1e-5);
      if (is_socket) {
        EXPECT_LT(old.mesh.color[v].x, 0.6f);
      }
    }
  }
  EXPECT_GT(socket, 50u);
  EXPECT_GT(stone, 50u);
}

TEST(Recolored, RefusesAnotherFruit) {
  const DiffusionSurfaces own = shapes::seeded_fruit();
  DiffusionSurfaces other = own;
  other.position[0].x += 0.001f;
  EXPECT_THROW(recolored(Solid{}, own, other, {}), Error);
}

}  // namespace
}  // namespace pomona
