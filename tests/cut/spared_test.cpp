// Parts that knives spare: whole in one piece, a socket in the others, and all of it closed.
#include "generator/cut/spared.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/cut/cut.h"
#include "generator/knife/parse_knife.h"
#include "tests/cut/cut_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

constexpr double outer = 0.03, inner = 0.012;

shapes::Paint stone_paint() {
  return {.front = {0.9f, 0.8f, 0.4f},
          .back = {0.4f, 0.2f, 0.1f},
          .name = "stone",
          .front_part = "flesh",
          .back_part = "stone"};
}

DiffusionSurfaces peach() { return shapes::nested_spheres(outer, inner, 10, shapes::skin_paint(), stone_paint()); }

/// The stone as a fruit of its own.
DiffusionSurfaces bare_stone() { return shapes::sphere(inner, 10, shapes::skin_paint()); }

std::vector<Knife> parsed(const std::vector<std::string>& words) {
  std::vector<Knife> knives;
  for (const std::string& word : words) knives.push_back(parse_knife(word));
  return knives;
}

std::vector<int> part_of(const DiffusionSurfaces& surfaces, const std::string& name) {
  const auto at = std::find(surfaces.part_names.begin(), surfaces.part_names.end(), name);
  return {static_cast<int>(at - surfaces.part_names.begin())};
}

Cut cut_sparing(const DiffusionSurfaces& surfaces, const std::vector<Knife>& knives,
                const std::string& part = "stone") {
  const std::vector<int> parts = part_of(surfaces, part);
  CutOptions options;
  options.spared_parts = parts;
  return cut(surfaces, knives, options);
}

/// How many pieces show a part where they were not cut.
int pieces_with_walls_of(const Cut& cut, const std::string& part) {
  const auto number = static_cast<std::int32_t>(
      std::find(cut.section.part_names.begin(), cut.section.part_names.end(), part) - cut.section.part_names.begin());
  return static_cast<int>(std::count_if(cut.pieces.begin(), cut.pieces.end(), [&](const CutPiece& piece) {
    return std::find(piece.part.begin(), piece.part.end(), number) != piece.part.end();
  }));
}

TEST(ClosedShells, are_all_triangles_around_a_stone_as_long_as_none_is_missing) {
  const auto count = [](const DiffusionSurfaces& surfaces) {
    const std::vector<int> parts = part_of(surfaces, "stone");
    const std::vector<std::uint32_t> shell = closed_shells(surfaces, parts);
    EXPECT_LE(*std::max_element(shell.begin(), shell.end()), 1u);
    return std::count(shell.begin(), shell.end(), 1u);
  };
  DiffusionSurfaces whole = peach(), open = peach();
  EXPECT_EQ(count(whole), std::count(whole.back_part.begin(), whole.back_part.end(), part_of(whole, "stone").front()));
  open.triangle.back() = glm::uvec3(open.triangle.back().x);
  EXPECT_EQ(count(open), 0);
}

const std::vector<std::vector<std::string>> many_ways = {
    {"half"},
    {"across"},
    {"plane:1,0,0,4mm"},
    {"plane:0.3,1,0.2,-3mm"},
    {"wedges:5"},
    {"slices:7mm"},
    {"dice:9mm"},
    {"half", "across", "plane:1,0.2,0,2mm"},
    {"ball:20mm,at=10mm,0mm,4mm"},
    {"half", "core:10mm"},
    {"core:30mm", "plane:1,1,0,1mm"},
};

TEST(Spared, PiecesAreClosedAndAddUp) {
  const double whole = shapes::volume_of(cut(peach(), {}));
  for (const std::vector<std::string>& words : many_ways) {
    SCOPED_TRACE(words.front());
    const Cut found = cut_sparing(peach(), parsed(words));
    EXPECT_TRUE(found.warnings.empty());
    shapes::expect_whole(found, whole);
    EXPECT_EQ(pieces_with_walls_of(found, "stone"), 1) << "one piece has all of the stone";
  }
}

TEST(Spared, ThePieceWithTheGreaterPartHasAllOfIt) {
  for (const char* word : {"plane:1,0,0,4mm", "plane:1,0,0,-4mm", "plane:0.3,1,0.2,3mm"}) {
    SCOPED_TRACE(word);
    const std::vector<Knife> knife = parsed({word});
    const Cut plain = cut(peach(), knife), stone = cut(bare_stone(), knife), found = cut_sparing(peach(), knife);
    ASSERT_EQ(found.pieces.size(), 2u);
    ASSERT_EQ(stone.pieces.size(), 2u);
    const std::size_t home = stone.pieces[0].volume > stone.pieces[1].volume ? 0 : 1;
    const double moved = stone.pieces[1 - home].volume;
    EXPECT_NEAR(found.pieces[home].volume, plain.pieces[home].volume + moved, 1e-6 * outer * outer * outer);
    EXPECT_NEAR(found.pieces[1 - home].volume, plain.pieces[1 - home].volume - moved, 1e-6 * outer * outer * outer);
  }
}

TEST(Spared, OfEqualPartsTheFirstCellHasIt) {
  for (const char* word : {"half", "plane:1,0,0,0mm", "plane:1,0,0,0.1mm", "plane:1,0,0,-0.1mm"}) {
    const Cut found = cut_sparing(peach(), parsed({word}));
    ASSERT_EQ(found.pieces.size(), 2u);
    EXPECT_GT(found.pieces[0].volume, found.pieces[1].volume) << word;
  }
}

TEST(Spared, TheSectionStillGoesThrough) {
  for (const std::vector<std::string>& words : many_ways) {
    const std::vector<Knife> knives = parsed(words);
    const CrossSection plain = cut(peach(), knives).section, found = cut_sparing(peach(), knives).section;
    EXPECT_TRUE(plain.position == found.position && plain.triangle == found.triangle) << words.front();
  }
}

TEST(Spared, NothingOfAPieceIsCutWithinIt) {
  const Cut found = cut_sparing(peach(), parsed({"half", "plane:1,0.1,0,3mm"}));
  for (const CutPiece& piece : found.pieces) {
    for (const CutPiece::CapTriangle& cap : piece.caps) {
      const glm::uvec3& t = found.section.triangle[cap.triangle];
      const std::vector<glm::vec3>& p = found.section.position;
      EXPECT_GT(glm::length(p[t.x] + p[t.y] + p[t.z]) / 3, 0.97 * inner);
    }
  }
}

TEST(Spared, WhatStandsOutShowsTheBackAndTheSocketTheFront) {
  const DiffusionSurfaces fruit = peach();
  const Cut found = cut_sparing(fruit, parsed({"half"}));
  const std::int32_t stone = part_of(fruit, "stone").front();
  int domes = 0, sockets = 0;
  for (const CutPiece& piece : found.pieces) {
    for (std::size_t v = 0; v < piece.position.size(); ++v) {
      if (glm::length(piece.position[v]) > 1.01 * inner) continue;
      const float outwards = glm::dot(piece.normal[v], glm::normalize(piece.position[v]));
      if (piece.part[v] == stone) {
        ++domes;
        EXPECT_EQ(piece.color[v], stone_paint().back);
        EXPECT_GT(outwards, 0.9f);
      } else {
        ++sockets;
        EXPECT_EQ(piece.color[v], stone_paint().front);
        EXPECT_LT(outwards, -0.9f);
      }
    }
  }
  EXPECT_GT(domes, 50);
  EXPECT_EQ(domes, sockets);
}

TEST(Spared, ManyAreSparedEachForItself) {
  DiffusionSurfaces fruit = shapes::sphere(outer, 10, shapes::skin_paint());
  for (const glm::dvec3& at : {glm::dvec3(0.012, 0, 0.001), glm::dvec3(-0.012, 0.002, -0.001), glm::dvec3(0, 0.014, 0)})
    fruit = joined(fruit, shapes::moved(shapes::sphere(0.005, 4, stone_paint()), at));
  const double whole = shapes::volume_of(cut(fruit, {}));
  const Cut found = cut_sparing(fruit, parsed({"half"}));
  shapes::expect_whole(found, whole);
  EXPECT_EQ(pieces_with_walls_of(found, "stone"), 2) << "one of them lies more in one half, one in the other";
}

TEST(Spared, WhatIsOpenOrCrossesIsCutThrough) {
  const DiffusionSurfaces skin = shapes::sphere(outer, 10, shapes::skin_paint());
  const DiffusionSurfaces ball = shapes::sphere(0.008, 6, stone_paint());
  const std::vector<DiffusionSurfaces> fruits = {
      joined(skin, shapes::tilted(shapes::open_sheet(0.02, 0.001, 3, stone_paint()))),
      joined(joined(skin, shapes::moved(ball, {0.004, 0, 0})), shapes::moved(ball, {-0.004, 0, 0})),
      joined(skin, shapes::moved(ball, {outer, 0, 0})),
  };
  for (const DiffusionSurfaces& fruit : fruits) {
    const Cut plain = cut(fruit, parsed({"half"})), found = cut_sparing(fruit, parsed({"half"}));
    ASSERT_EQ(found.warnings.size(), plain.warnings.size() + 1);
    EXPECT_NE(found.warnings.back().find("part \"stone\" is cut through"), std::string::npos);
    ASSERT_EQ(found.pieces.size(), plain.pieces.size());
    for (std::size_t i = 0; i < found.pieces.size(); ++i) EXPECT_EQ(found.pieces[i].volume, plain.pieces[i].volume);
  }
}

TEST(Spared, KnivesThatMissItLeaveAllAsItWas) {
  const std::vector<Knife> knife = parsed({"plane:0,1,0,20mm"});
  shapes::expect_same(cut_sparing(peach(), knife), cut(peach(), knife));
}

/// A ball and a leaf that is sunk in it a little, on one side of the axis or on both.
DiffusionSurfaces leafy(double from, double to) {
  shapes::Paint green = shapes::skin_paint();
  green.front_part = green.back_part = "leaf";
  return joined(shapes::sphere(outer, 10, shapes::skin_paint()),
                shapes::box({from, 0.029, -0.004}, {to, 0.032, 0.004}, 16, green));
}

TEST(HeldBack, ACorerLeavesLeavesWhole) {
  for (const double from : {-0.011, -0.001, 0.0055}) {
    SCOPED_TRACE(from);
    const DiffusionSurfaces fruit = leafy(from, from + 0.022);
    const Cut found = cut(fruit, parsed({"core:12mm"}));
    shapes::expect_whole(found, shapes::volume_of(cut(fruit, {})));
    EXPECT_EQ(pieces_with_walls_of(found, "leaf"), 1);
    EXPECT_GT(pieces_with_walls_of(cut(fruit, parsed({"ball:9mm,at=9mm,30mm,0"})), "leaf"), 1) << "others cut them";
  }
}

/// A leaf whose foot is in the core goes with it, however far it reaches beyond.
TEST(HeldBack, ALeafGoesWithWhatItSitsOn) {
  const auto volume_of_core = [](const DiffusionSurfaces& fruit) {
    const Cut found = cut(fruit, parsed({"core:12mm"}));
    double min = 1;
    for (const CutPiece& piece : found.pieces) min = std::min(min, piece.volume);
    return min;
  };
  const double bare = volume_of_core(shapes::sphere(outer, 10, shapes::skin_paint()));
  // Where the leaf is sunk in, the place belongs to the flesh.
  const double leaf = shapes::volume_of(cut(leafy(-0.002, 0.02), {})) -
                      shapes::volume_of(cut(shapes::sphere(outer, 10, shapes::skin_paint()), {}));
  EXPECT_LT(leaf, 0.99 * 0.022 * 0.003 * 0.008);
  EXPECT_NEAR(volume_of_core(leafy(-0.002, 0.02)) - bare, leaf, 1e-3 * leaf);
  EXPECT_NEAR(volume_of_core(leafy(0.0055, 0.0275)) - bare, 0, 1e-3 * leaf);
}

/// A corer does not push aside a leaf that a plane has cut.
TEST(HeldBack, WhatIsCutAlreadyIsCut) {
  const DiffusionSurfaces fruit = leafy(-0.02, 0.02);
  const Cut found = cut(fruit, parsed({"half", "core:12mm"}));
  shapes::expect_whole(found, shapes::volume_of(cut(fruit, {})));
  EXPECT_EQ(pieces_with_walls_of(found, "leaf"), 4);
}

}  // namespace
}  // namespace pomona
