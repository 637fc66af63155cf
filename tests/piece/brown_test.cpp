// Browning of cut faces.
#include "generator/piece/brown.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/cut/cut.h"
#include "generator/knife/knife.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/slice.h"
#include "generator/surface/skin_depth.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

const Color cream(0.8f, 0.7f, 0.4f), brown(0.2f, 0.1f, 0.03f);

Template browning_fruit() {
  Template fruit;
  fruit.parts = {"skin", "flesh"};
  fruit.browning.parts = {{.part = 1, .color = brown, .rate = 1, .max = 0.8}};
  fruit.individual.browning = 0.5;
  return fruit;
}

DiffusionSurfaces ball() {
  shapes::Paint paint = shapes::skin_paint();
  paint.back = cream;
  return shapes::sphere(0.03, 12, paint);
}

/// A cut ball whose faces have the colour of its flesh.
CrossSection section_of(const DiffusionSurfaces& surfaces, const std::vector<std::string>& knives) {
  std::vector<Knife> parsed;
  for (const std::string& knife : knives) parsed.push_back(parse_knife(knife));
  CrossSection section = cut(surfaces, parsed).section;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    section.color[v] = cream;
    section.part[v] = 1;
  }
  return section;
}

double share_of_way(const Color& color) {
  const glm::dvec3 a(to_oklab(cream)), b(to_oklab(brown)), c(to_oklab(color));
  return glm::dot(c - a, b - a) / glm::dot(b - a, b - a);
}

TEST(Browning, of_nothing_keeps_every_bit) {
  Template fruit = browning_fruit();
  fruit.individual.browning = 0;
  const CrossSection fresh = section_of(ball(), {"half"});
  ASSERT_FALSE(fresh.color.empty());
  EXPECT_EQ(browned(fresh, ball(), fruit).color, fresh.color);
  fruit.individual.browning = 1;
  fruit.browning.parts.clear();
  EXPECT_EQ(browned(fresh, ball(), fruit).color, fresh.color);
}

TEST(Browning, only_colours_of_named_parts_change) {
  const DiffusionSurfaces surfaces = ball();
  CrossSection fresh = section_of(surfaces, {"half"});
  fresh.part[3] = 0;
  const CrossSection old = browned(fresh, surfaces, browning_fruit());
  EXPECT_EQ(old.color[3], cream);
  EXPECT_NE(old.color[4], cream);
  EXPECT_EQ(old.position, fresh.position);
  EXPECT_EQ(old.part, fresh.part);
}

TEST(Browning, grows_with_time_and_stays_between_fresh_and_brown) {
  Template fruit = browning_fruit();
  fruit.browning.patches = 0.8;
  const DiffusionSurfaces surfaces = ball();
  const CrossSection fresh = section_of(surfaces, {"half"});
  std::vector<double> before(fresh.position.size(), 0);
  for (const double time : {0.1, 0.3, 0.6, 1.0}) {
    fruit.individual.browning = time;
    const CrossSection now = browned(fresh, surfaces, fruit);
    for (std::size_t v = 0; v < before.size(); ++v) {
      const double share = share_of_way(now.color[v]);
      EXPECT_GE(share, before[v] - 1e-5);
      EXPECT_LE(share, 0.8 + 1e-5);
      before[v] = share;
    }
  }
}

TEST(Browning, goes_by_the_depth_below_the_skin) {
  Template fruit = browning_fruit();
  fruit.browning.depth = {{{0, 0.0}, {0.02, 1.0}}};
  const DiffusionSurfaces surfaces = ball();
  const CrossSection old = browned(section_of(surfaces, {"half"}), surfaces, fruit);
  const SkinDepth skin(surfaces);
  for (std::size_t v = 0; v < old.position.size(); ++v) {
    const double speed = std::min(1.0, skin.depth(glm::dvec3(old.position[v])) / 0.02);
    EXPECT_NEAR(share_of_way(old.color[v]), 0.8 * (1 - std::exp(-1.5 * speed)), 1e-4);
  }
}

TEST(Browning, is_faster_near_the_named_surface) {
  Template fruit = browning_fruit();
  const DiffusionSurfaces surfaces = shapes::nested_spheres(0.03, 0.01, 12);
  SurfaceSketch core;
  core.name = surfaces.surface_names.back();
  fruit.surfaces = {core};
  fruit.browning.near = BrowningSketch::Near{.surface = 0, .within = 0.004, .faster = 3};
  const CrossSection old = browned(section_of(surfaces, {"half"}), surfaces, fruit);
  double near = 0, far = 1;
  for (std::size_t v = 0; v < old.position.size(); ++v) {
    const double radius = glm::length(glm::dvec3(old.position[v]));
    if (std::fabs(radius - 0.01) < 2e-4) near = std::max(near, share_of_way(old.color[v]));
    if (radius > 0.016) far = std::min(far, share_of_way(old.color[v]));
  }
  EXPECT_NEAR(near, 0.8 * (1 - std::exp(-4.5)), 0.02);
  EXPECT_NEAR(far, 0.8 * (1 - std::exp(-1.5)), 1e-4);
}

TEST(Browning, two_cuts_agree_where_they_meet) {
  Template fruit = browning_fruit();
  fruit.browning.depth = {{{0, 0.1}, {0.01, 1.0}}};
  fruit.browning.patches = 0.7;
  fruit.individual.patches = 77;
  const DiffusionSurfaces surfaces = ball();
  const CrossSection both = browned(section_of(surfaces, {"half", "across"}), surfaces, fruit);
  const CrossSection one = browned(section_of(surfaces, {"half"}), surfaces, fruit);
  const auto key = [](const glm::vec3& p) { return std::tuple(p.x, p.y, p.z); };
  std::map<std::tuple<float, float, float>, Color> known;
  for (std::size_t v = 0; v < one.position.size(); ++v) known[key(one.position[v])] = one.color[v];
  std::size_t shared = 0;
  for (std::size_t v = 0; v < both.position.size(); ++v) {
    const auto [at, is_new] = known.try_emplace(key(both.position[v]), both.color[v]);
    if (is_new) continue;
    ++shared;
    EXPECT_EQ(at->second, both.color[v]);
  }
  EXPECT_GT(shared, 10u);
}

/// Knives spare the stone of a peach. The half without the stone has the socket, whose wall was inside the flesh
/// before.
struct SparedPeach {
  DiffusionSurfaces surfaces =
      shapes::nested_spheres(0.03, 0.01, 12, shapes::skin_paint(),
                             {.front = cream, .name = "stone", .front_part = "flesh", .back_part = "stone"});
  Template fruit = browning_fruit();

  std::vector<CutPiece> halves() {
    fruit.parts = surfaces.part_names;
    const auto number = [&](const char* part) {
      return static_cast<int>(std::find(fruit.parts.begin(), fruit.parts.end(), part) - fruit.parts.begin());
    };
    fruit.browning.parts[0].part = number("flesh");
    fruit.spared = {number("stone")};
    const std::vector<Knife> knives{parse_knife("half")};
    CutOptions options;
    options.spared_parts = fruit.spared;
    return cut(surfaces, knives, options).pieces;
  }
};

TEST(Browning, of_a_spared_socket_is_that_of_a_cut_face) {
  SparedPeach peach;
  const std::vector<CutPiece> fresh = peach.halves(), old = browned(fresh, peach.surfaces, peach.fruit);
  ASSERT_EQ(old.size(), 2u);
  std::size_t socket = 0, kept = 0;
  for (std::size_t i = 0; i < old.size(); ++i) {
    ASSERT_EQ(fresh[i].bared.size(), fresh[i].position.size());
    for (std::size_t v = 0; v < old[i].position.size(); ++v) {
      const bool is_within = glm::length(glm::dvec3(old[i].position[v])) < 0.02;
      EXPECT_EQ(fresh[i].bared[v] != 0, is_within);
      if (is_within && peach.fruit.parts[static_cast<std::size_t>(old[i].part[v])] == "flesh") {
        EXPECT_NEAR(share_of_way(old[i].color[v]), 0.8 * (1 - std::exp(-1.5)), 1e-4);
        ++socket;
      } else {
        EXPECT_EQ(old[i].color[v], fresh[i].color[v]) << "neither the skin nor the stone browns";
        ++kept;
      }
    }
  }
  EXPECT_GT(socket, 50u);
  EXPECT_GT(kept, socket);
}

TEST(Browning, of_a_spared_socket_is_in_the_pieces_of_a_slice) {
  SparedPeach peach;
  peach.halves();
  const GrownFruit grown{peach.surfaces, {}, peach.surfaces};
  const std::vector<Knife> knives{parse_knife("half")};
  const Slices halves = slice({grown, peach.fruit, knives, "peach"}, nullptr);
  double max = 0;
  for (const Solid& half : halves.pieces) {
    for (std::size_t t = 0; t < half.mesh.triangle.size(); ++t) {
      const std::uint32_t v = half.mesh.triangle[t].x;
      if (half.mesh.cut_face[t] < 0 && half.look->part_names[static_cast<std::size_t>(half.mesh.part[v])] == "flesh")
        max = std::max(max, share_of_way(half.mesh.color[v]));
    }
  }
  EXPECT_NEAR(max, 0.8 * (1 - std::exp(-1.5)), 1e-4);
}

}  // namespace
}  // namespace pomona
