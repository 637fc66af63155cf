// slice() makes the same pieces of one fruit or many; unwanted pieces are not diffused.
#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "generator/base/units.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/contacts.h"
#include "tests/shapes/seeded_fruit.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

const std::vector<Knife>& quarters() {
  static const std::vector<Knife> knives{parse_knife("wedges:4")};
  return knives;
}

std::size_t interior_vertices(const CrossSection& section) {
  return static_cast<std::size_t>(std::count(section.interior.begin(), section.interior.end(), 1));
}

TEST(Slice, GivesManyFruitsWhatItGivesEachAlone) {
  const DiffusionSurfaces seeded = shapes::seeded_fruit(), nested = shapes::nested_spheres(0.05, 0.02, 8);
  const GrownFruit first{seeded, {}, seeded}, second{nested, {}, nested};
  const Template plain;
  const auto diffuser = make_pmvc_diffuser({.quality = Quality::draft, .threads = {}});
  const std::vector<SliceTask> tasks{{first, plain, quarters(), "seeded"}, {second, plain, quarters(), "nested"}};
  const std::vector<Slices> together = slice(tasks, diffuser.get());
  ASSERT_EQ(together.size(), 2u);
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    const Slices alone = slice(tasks[i], diffuser.get());
    EXPECT_EQ(together[i].section.color, alone.section.color);
    ASSERT_EQ(together[i].pieces.size(), alone.pieces.size());
    for (std::size_t k = 0; k < alone.pieces.size(); ++k) {
      EXPECT_EQ(together[i].pieces[k].name, alone.pieces[k].name);
      EXPECT_EQ(together[i].pieces[k].mesh.position, alone.pieces[k].mesh.position);
      EXPECT_EQ(together[i].pieces[k].mesh.color, alone.pieces[k].mesh.color);
    }
  }
}

TEST(Slice, TakesTheLargestPiecesThatAreChosen) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  const GrownFruit grown{ball, {}, ball};
  const std::vector<Knife> knives{parse_knife("plane:0,1,0,10mm"), parse_knife("plane:0,1,0,40mm")};
  const Template plain;
  const Slices all = slice({grown, plain, knives, "ball"}, nullptr);
  ASSERT_EQ(all.pieces.size(), 3u);
  const Slices one = slice({grown, plain, knives, "ball", PieceChoice{.take = 1}}, nullptr);
  ASSERT_EQ(one.pieces.size(), 1u);
  EXPECT_EQ(one.pieces[0].name, "ball");
  for (const Solid& piece : all.pieces) EXPECT_LE(piece.volume, one.pieces[0].volume);
  const Slices small = slice({grown, plain, knives, "ball", PieceChoice{.largest = 0.5}}, nullptr);
  EXPECT_EQ(small.pieces.size(), 2u);
}

/// A ball beside the origin, as a placed instance.
DiffusionSurfaces ball_at(const glm::vec3& center, std::int32_t instance) {
  DiffusionSurfaces ball = shapes::sphere(0.05, 8, shapes::skin_paint());
  for (glm::vec3& p : ball.position) p += center;
  ball.instance.assign(ball.triangle_count(), instance);
  return ball;
}

TEST(Slice, TellsWhichInstancesAPieceIsOf) {
  // A ball of the fruit's own that overlaps an instance, and one instance on either side of the knife.
  const DiffusionSurfaces middle = joined(ball_at({0, 0, 0}, 0), ball_at({0, 0.06f, 0}, 3));
  const DiffusionSurfaces all = joined(joined(middle, ball_at({0.2f, 0, 0}, 1)), ball_at({-0.2f, 0, 0}, 2));
  const Template plain;
  const std::vector<Knife> knives{parse_knife("plane:1,0,0,0.1mm")};
  std::vector<std::vector<std::int32_t>> found;
  for (const Solid& piece : slice({{all, {}, all}, plain, knives, "balls"}, nullptr).pieces)
    found.push_back(piece.instances);
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<std::vector<std::int32_t>>{{0, 3}, {0, 3}, {1}, {2}}));

  DiffusionSurfaces alone = all;
  alone.instance.clear();
  for (const Solid& piece : slice({{alone, {}, alone}, plain, knives, "balls"}, nullptr).pieces)
    EXPECT_TRUE(piece.instances.empty());
}

TEST(Slice, LeavesWhatTheTemplateSparesInOnePiece) {
  const DiffusionSurfaces peach =
      shapes::nested_spheres(0.05, 0.02, 8, shapes::skin_paint(), {.front_part = "flesh", .back_part = "stone"});
  const GrownFruit grown{peach, {}, peach};
  const std::vector<Knife> knives{parse_knife("plane:1,0,0,5mm")};
  Template fruit;
  const Slices plain = slice({grown, fruit, knives, "peach"}, nullptr);
  fruit.spared = {static_cast<int>(std::find(peach.part_names.begin(), peach.part_names.end(), "stone") -
                                   peach.part_names.begin())};
  const Slices spared = slice({grown, fruit, knives, "peach"}, nullptr);
  ASSERT_EQ(spared.pieces.size(), 2u);
  EXPECT_GT(spared.pieces[0].volume, plain.pieces[0].volume);
  EXPECT_LT(spared.pieces[1].volume, plain.pieces[1].volume);
  for (const Solid& piece : spared.pieces) EXPECT_TRUE(piece.closed);
  EXPECT_EQ(spared.section.triangle, plain.section.triangle);

  // They touch in the flesh that was cut, and around the stone; together that is what the knife has laid bare.
  const std::vector<PieceContact> touching = contacts_of(spared.pieces);
  ASSERT_EQ(touching.size(), 2u);
  EXPECT_EQ(touching[0].cut, around_spared);
  EXPECT_EQ(touching[1].cut, 0);
  const auto surface = [](const SolidMesh& mesh) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangle.size(); ++t) area += 0.5 * glm::length(mesh.area_vector(t));
    return area;
  };
  const std::vector<PieceContact> through = contacts_of(plain.pieces);
  ASSERT_EQ(through.size(), 1u);
  const double skin = surface(plain.pieces[0].mesh) + surface(plain.pieces[1].mesh) - 2 * through[0].area;
  const double bare = surface(spared.pieces[0].mesh) + surface(spared.pieces[1].mesh) - skin;
  EXPECT_NEAR(2 * (touching[0].area + touching[1].area) / bare, 1, 1e-6);
  EXPECT_NEAR(touching[0].area / (2 * pi * 0.02 * 0.015), 1, 0.02) << "the part of a ball of 20 mm beyond 5 mm";
  ASSERT_EQ(touching[0].parts.size(), 1u);
  const auto [first, second] = touching[0].parts.begin()->first;
  EXPECT_EQ(peach.part_names[static_cast<std::size_t>(first)], "stone");
  EXPECT_EQ(peach.part_names[static_cast<std::size_t>(second)], "flesh");
}

TEST(Slice, GivesEachPieceTheSpotsOfItsSkinThatStandOut) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  GrownFruit grown{ball, {}, ball};
  for (const double z : {-1.0, 1.0, 0.0}) {
    Spot spot;
    spot.normal = glm::dvec3(std::sqrt(1 - z * z), 0, z);
    spot.center = 0.05 * spot.normal;
    spot.radius = 0.002;
    spot.relief = 1e-4;
    grown.raised.push_back(spot);
  }
  const std::vector<Knife> knives{parse_knife("half")};
  const Template plain;
  const Slices halves = slice({grown, plain, knives, "ball"}, nullptr);
  ASSERT_EQ(halves.pieces.size(), 2u);
  for (const Solid& half : halves.pieces) EXPECT_EQ(half.raised.size(), 2u) << "its own, and the one on the cut";
}

TEST(Slice, TellsOfEveryPieceWhichPartsTheWholeFruitShows) {
  const DiffusionSurfaces peach =
      shapes::nested_spheres(0.05, 0.02, 8, shapes::skin_paint(), {.front_part = "flesh", .back_part = "stone"});
  const GrownFruit grown{peach, {}, peach};
  const std::vector<Knife> knives{parse_knife("plane:1,0,0,10mm"), parse_knife("plane:1,0,0,-10mm")};
  for (const Solid& piece : slice({grown, Template{}, knives, "peach"}, nullptr).pieces) {
    ASSERT_EQ(piece.look->on_skin.size(), peach.part_names.size());
    for (std::size_t part = 0; part < peach.part_names.size(); ++part)
      EXPECT_EQ(piece.look->on_skin[part] != 0, peach.part_names[part] == "skin") << peach.part_names[part];
  }
}

/// The half-planes of a variant's wedges keep off its walls; the drawing is cut at 0 degrees.
TEST(Slice, TurnsTheWedgesOfVariants) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  const GrownFruit grown{ball, {}, ball};
  Template fruit;
  fruit.symmetry = FoldSymmetry{{0, 0.5 * pi, pi, 1.5 * pi}};
  SliceTask task{.grown = grown, .variant = fruit, .knives = quarters(), .name = "ball"};
  const auto along_x = [](const Slices& slices) {
    return std::any_of(slices.section.faces.begin(), slices.section.faces.end(),
                       [](const CutFace& face) { return std::fabs(face.normal.z) > 0.999; });
  };
  const Slices turned = slice(task, nullptr);
  EXPECT_FALSE(along_x(turned));
  EXPECT_EQ(turned.pieces.size(), 4u);
  task.origin.growing.as_drawn = true;
  EXPECT_TRUE(along_x(slice(task, nullptr)));
}

/// A crumb is dropped unless it is asked for. Crumbs that together are large enough are kept.
TEST(Slice, LeavesOutCrumbsThatAreLessThanOneTogether) {
  const DiffusionSurfaces box = shapes::box(glm::dvec3(-0.03), glm::dvec3(0.03), 2, shapes::skin_paint());
  const GrownFruit grown{box, {}, box};
  const Template plain;
  const std::vector<Knife> knives{parse_knife("half"), parse_knife("plane:1,1,1,0.0516"),
                                  parse_knife("plane:-1,1,1,0.0516")};
  const SliceTask without{.grown = grown, .variant = plain, .knives = knives, .name = "box"};
  SliceTask with = without;
  with.crumbs = true;
  const auto crumbs = [](const Slices& slices) {
    return std::count_if(slices.pieces.begin(), slices.pieces.end(), [](const Solid& piece) { return piece.crumb; });
  };
  const Slices kept = slice(with, nullptr), left = slice(without, nullptr);
  ASSERT_EQ(crumbs(kept), 2);
  EXPECT_EQ(crumbs(left), 0);
  EXPECT_EQ(left.pieces.size() + 2, kept.pieces.size());
  double gone = 0, whole = 0;
  for (const Solid& piece : kept.pieces) whole += piece.volume, gone += piece.crumb ? piece.volume : 0;
  EXPECT_LT(gone, 1e-6 * whole);
}

/// What a knife meets of a root hair beside the fruit is a speck of its section, but still a part of its half.
TEST(Slice, LeavesCrumbsOutOfTheSectionAndNothingOutOfPieces) {
  const auto ball = [](double radius, double x) {
    return shapes::moved(shapes::sphere(radius, 8, shapes::skin_paint()), {x, 0, 0});
  };
  const DiffusionSurfaces whole = joined(joined(ball(0.05, 0), ball(0.0008, 0.055)), ball(0.004, -0.055));
  const GrownFruit grown{whole, {}, whole};
  const std::vector<Knife> knives{parse_knife("half")};
  const Template plain;
  const SliceTask without{.grown = grown, .variant = plain, .knives = knives, .name = "bulb"};
  SliceTask with = without;
  with.crumbs = true;
  const Slices left = slice(without, nullptr), kept = slice(with, nullptr);
  const auto farthest = [](const CrossSection& section) {
    std::pair<float, float> ends{0, 0};
    for (const glm::vec3& p : section.position) ends = {std::min(ends.first, p.x), std::max(ends.second, p.x)};
    return ends;
  };
  EXPECT_NEAR(farthest(kept.section).second, 0.0558, 1e-5);
  for (const CrossSection* section : {&left.section, &left.styled}) {
    EXPECT_LT(farthest(*section).second, 0.0501) << "the hair";
    EXPECT_NEAR(farthest(*section).first, -0.059, 1e-4) << "the seed is no crumb";
  }
  ASSERT_EQ(left.pieces.size(), kept.pieces.size());
  for (std::size_t i = 0; i < left.pieces.size(); ++i) {
    EXPECT_EQ(left.pieces[i].volume, kept.pieces[i].volume);
    EXPECT_EQ(left.pieces[i].mesh.position, kept.pieces[i].mesh.position);
    EXPECT_TRUE(left.pieces[i].closed);
  }
}

TEST(Slice, DiffusesOnlyWhatChosenPiecesShow) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  const GrownFruit grown{ball, {}, ball};
  const std::vector<Knife> knives{parse_knife("slices:9")};
  const Template plain;
  const Slices all = slice({grown, plain, knives, "ball"}, nullptr);
  const Slices one = slice({grown, plain, knives, "ball", PieceChoice{.take = 1}}, nullptr);
  EXPECT_LT(interior_vertices(one.section), interior_vertices(all.section) / 2);
  EXPECT_GT(interior_vertices(one.section), 0u);
}

TEST(Slice, LeavesOutPiecesWhereTheSectionAloneIsWanted) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  const Slices slices = shapes::sliced(ball, quarters(), {}, nullptr, {.pieces = false});
  EXPECT_TRUE(slices.pieces.empty());
  EXPECT_EQ(slices.piece_count, 4u);
  EXPECT_FALSE(slices.section.triangle.empty());
}

TEST(Slice, LeavesAFruitWithoutKnivesWhole) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 10, shapes::skin_paint());
  const Slices slices = shapes::sliced(ball, {});
  ASSERT_EQ(slices.pieces.size(), 1u);
  EXPECT_TRUE(slices.pieces[0].closed);
  EXPECT_TRUE(slices.section.triangle.empty());
}

TEST(Slice, KeepsWhatColouredTheFacesWhenAsked) {
  const DiffusionSurfaces ball = shapes::nested_spheres(0.05, 0.02, 8);
  const auto diffuser = make_pmvc_diffuser({.quality = Quality::draft, .threads = {}});
  for (const Solid& piece : shapes::sliced(ball, quarters(), {}, diffuser.get()).pieces) {
    EXPECT_EQ(piece.section_colors, nullptr);
  }
  for (const Solid& piece :
       shapes::sliced(ball, quarters(), {}, diffuser.get(), {.keep_section_colors = true}).pieces) {
    EXPECT_NE(piece.section_colors, nullptr);
  }
}

}  // namespace
}  // namespace pomona
