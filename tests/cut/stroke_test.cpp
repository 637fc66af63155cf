// Cuts along polylines: pieces add up, are closed, and lie where geometry says.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/cut/cut.h"
#include "generator/knife/parse_knife.h"
#include "generator/knife/read_stroke.h"
#include "generator/knife/stroke.h"
#include "tests/base/temporary_folder.h"
#include "tests/cut/cut_checks.h"
#include "tests/shapes/shapes.h"

namespace pomona {
namespace {

using shapes::expect_whole;
using shapes::volume_of;

Knife stroke_knife(std::vector<glm::dvec2> points) { return {PlaneCut(StrokeKnife{std::move(points)}), "stroke"}; }

DiffusionSurfaces box() { return shapes::box({-0.03, 0, -0.02}, {0.03, 0.05, 0.04}, 3, shapes::skin_paint()); }
constexpr double box_volume = 0.06 * 0.05 * 0.06;

TEST(Stroke, TellsItsSides) {
  const Stroke stroke({{0, 0}, {1, 0}, {1, 1}});
  EXPECT_NEAR(stroke.nearest({0.5, -0.25}).distance, 0.25, 1e-15);
  EXPECT_NEAR(stroke.nearest({0.5, 0.25}).distance, -0.25, 1e-15);
  EXPECT_NEAR(stroke.nearest({-5, 0.25}).distance, -0.25, 1e-15) << "goes on straight";
  EXPECT_NEAR(stroke.nearest({1.3, -0.4}).distance, 0.5, 1e-15) << "round the corner";
  EXPECT_EQ(stroke.nearest({1.1, 3}).facet, 1);
}

TEST(Stroke, TheNearestFacetIsTheFirstOfAllThatAreNearest) {
  // A wave, whose corners are as near to two facets.
  std::vector<glm::dvec2> points;
  for (int i = 0; i < 90; ++i) points.emplace_back(0.25 * i, i % 4 == 1 ? 0.5 : i % 4 == 3 ? -0.5 : 0.125 * (i % 3));
  const Stroke stroke(points);
  const RandomStream random({}, "tests/nearest facet");
  std::vector<glm::dvec2> places = points;
  for (std::uint64_t n = 0; n < 500; ++n)
    places.emplace_back(30 * random.uniform(2 * n) - 4, 6 * random.uniform(2 * n + 1) - 3);
  for (const glm::dvec2& p : places) {
    int first = 0;
    double least = 1e300;
    for (int i = 0; i < stroke.facets(); ++i) {
      const Stroke::Facet& f = stroke.facet(i);
      const glm::dvec2 way = p - f.start - std::clamp(f.along_of(p), f.from, f.to) * f.direction;
      if (glm::dot(way, way) < least) least = glm::dot(way, way), first = i;
    }
    const Stroke::Place found = stroke.nearest(p);
    EXPECT_EQ(found.facet, first);
    EXPECT_EQ(std::fabs(found.distance), std::sqrt(least));
  }
}

TEST(Stroke, AStraightOneIsAPlane) {
  const DiffusionSurfaces ball = shapes::sphere(0.05, 12, shapes::skin_paint());
  const Cut by_stroke = cut(ball, std::vector<Knife>{stroke_knife({{0.01, -0.01}, {0.01, 0.02}})});
  const Cut by_plane = cut(ball, std::vector<Knife>{parse_knife("plane:1,0,0,0.01")});
  ASSERT_EQ(by_stroke.pieces.size(), 2u);
  ASSERT_EQ(by_plane.pieces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(by_stroke.pieces[i].volume, by_plane.pieces[i].volume, 1e-12);
    EXPECT_TRUE(by_stroke.pieces[i].closed);
  }
}

TEST(Stroke, AZigzagThroughABox) {
  // Below it, right of the direction +x, the area is 0.025 on average: a sum of trapezia.
  const Cut result =
      cut(box(), std::vector<Knife>{stroke_knife({{-0.05, 0.02}, {-0.01, 0.03}, {0.01, 0.02}, {0.05, 0.03}})});
  ASSERT_EQ(result.pieces.size(), 2u);
  expect_whole(result, box_volume);
  const auto height = [](double x) {
    if (x < -0.01) return 0.02 + (x + 0.05) / 4;
    return x < 0.01 ? 0.03 - (x + 0.01) / 2 : 0.02 + (x - 0.01) / 4;
  };
  const double area = 0.02 * (height(-0.03) + 0.03) / 2 + 0.02 * 0.025 + 0.02 * (0.02 + height(0.03)) / 2;
  EXPECT_NEAR(result.pieces[1].volume, 0.06 * area, 1e-9);
  EXPECT_EQ(result.section.faces.size(), 3u);
  for (const CutFace& face : result.section.faces) EXPECT_EQ(face.stroke, 0);
}

TEST(Stroke, OverhangsAndEndsInsideTheFruit) {
  const DiffusionSurfaces ball = shapes::tilted(shapes::nested_spheres(0.05, 0.02, 8));
  const double whole = volume_of(cut(ball, {}));
  const Cut hook =
      cut(ball,
          std::vector<Knife>{stroke_knife({{-0.02, 0.0}, {0.02, 0.0}, {0.02, 0.02}, {-0.015, 0.022}, {-0.01, 0.035}})});
  EXPECT_EQ(hook.pieces.size(), 2u);
  expect_whole(hook, whole);
}

TEST(Stroke, ComposesWithOtherKnives) {
  const DiffusionSurfaces fruit = shapes::tilted(shapes::nested_spheres(0.05, 0.02, 8));
  const double whole = volume_of(cut(fruit, {}));
  const Knife wave = stroke_knife({{-0.06, 0.0}, {-0.03, 0.01}, {0, -0.01}, {0.03, 0.012}, {0.06, 0.0}});
  const Knife other = stroke_knife({{0.0, -0.06}, {0.01, -0.02}, {-0.01, 0.03}, {0.003, 0.06}});
  for (const std::vector<Knife>& knives : {std::vector<Knife>{wave, parse_knife("half")},
                                           {parse_knife("wedges:3"), wave},
                                           {wave, other},
                                           {parse_knife("slices:3"), other, parse_knife("plane:1,1,1,0.005")}}) {
    const Cut result = cut(fruit, knives);
    expect_whole(result, whole);
    EXPECT_GE(result.pieces.size(), 4u);
  }
}

/// Corners on a coarse grid: strokes pass through the box's vertices, along its edges and faces.
TEST(Stroke, ManyThroughManyShapes) {
  const std::vector<DiffusionSurfaces> fruits = {
      box(), shapes::sphere(0.05, 5, shapes::skin_paint()), shapes::torus(0.04, 0.015, 16, 9),
      shapes::hollow_ball(0.05, 0.044, 5),
      joined(shapes::nested_spheres(0.05, 0.02, 5), shapes::open_sheet(0.07, 0.003, 3))};
  const RandomStream random({11, 0}, "test/strokes");
  std::uint64_t draw = 0;
  int cuts = 0;
  for (std::size_t f = 0; f < fruits.size(); ++f) {
    const double whole = volume_of(cut(fruits[f], {}));
    for (int i = 0; i < 24; ++i) {
      std::vector<glm::dvec2> points;
      const bool coarse = random.below(draw++, 2) == 0;
      for (int k = 0; k < 5; ++k) {
        glm::dvec2 p(0.01 * static_cast<double>(random.below(draw, 11)) - 0.05,
                     0.01 * static_cast<double>(random.below(draw + 1, 7)));
        if (!coarse) p += 0.01 * glm::dvec2(random.uniform(draw + 2), random.uniform(draw + 3));
        draw += 4;
        points.push_back(p);
      }
      points = cleaned(points);
      if (points.size() < 2 || crosses_itself(points, {0, 0.025}, 0.2)) continue;
      SCOPED_TRACE(testing::Message() << "fruit " << f << ", stroke " << i);
      ++cuts;
      expect_whole(cut(fruits[f], std::vector<Knife>{stroke_knife(points)}, {.coarsest = 0.2, .finest = 0.05}), whole);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(cuts, 10);
}

TEST(Stroke, MayHaveFacetsInOnePlane) {
  std::vector<glm::dvec2> battlements;
  for (int i = -4; i < 4; ++i) {
    const double low = i % 2 == 0 ? 0.02 : 0.03;
    battlements.emplace_back(0.01 * i, low);
    battlements.emplace_back(0.01 * (i + 1), low);
  }
  const Cut result = cut(box(), std::vector<Knife>{stroke_knife(battlements), parse_knife("across")});
  expect_whole(result, box_volume);
  double below = 0;
  for (const CutPiece& piece : result.pieces) {
    for (const glm::vec3& p : piece.position) {
      if (p.y == 0) {
        below += piece.volume;
        break;
      }
    }
  }
  EXPECT_NEAR(below, 0.06 * 0.06 * 0.0225, 2e-9) << "merlons above the level half are pieces of their own";
}

TEST(Stroke, CrinkledSlices) {
  const DiffusionSurfaces ball = shapes::sphere(0.03, 10, shapes::skin_paint());
  const Cut result = cut(ball, std::vector<Knife>{parse_knife("crinkle:15mm")}, {.coarsest = 0.2, .finest = 0.05});
  expect_whole(result, volume_of(cut(ball, {})));
  EXPECT_GE(result.pieces.size(), 4u);
}

TEST(Stroke, IsSmoothWhereItTurnsALittleAndCreasedWhereItTurnsMuch) {
  const Cut waves = cut(box(), std::vector{parse_knife("crinkle:20mm")});
  const Cut zigzag =
      cut(box(), std::vector{stroke_knife({{-0.05, 0.02}, {-0.01, 0.02}, {0.01, 0.04}, {0.05, 0.0399}})});
  const auto normals_at_places = [](const CrossSection& section) {
    std::map<std::array<float, 3>, std::set<std::array<float, 3>>> at;
    for (std::size_t t = 0; t < section.triangle.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const glm::vec3 p = section.position[section.triangle[t][i]];
        const glm::vec3 n = section.normal.empty()
                                ? glm::vec3(section.faces[static_cast<std::size_t>(section.cut[t])].normal)
                                : section.normal[t][static_cast<std::size_t>(i)];
        at[{p.x, p.y, p.z}].insert({n.x, n.y, n.z});
      }
    }
    std::size_t max = 0;
    for (const auto& [place, normals] : at) max = std::max(max, normals.size());
    return max;
  };
  ASSERT_GT(waves.section.faces.size(), 10u);
  EXPECT_EQ(normals_at_places(waves.section), 1u) << "one normal to the bit, whichever facet it is seen on";
  EXPECT_EQ(normals_at_places(zigzag.section), 2u) << "45 degrees are a crease";
}

TEST(Stroke, CrossingItselfIsAnError) {
  EXPECT_TRUE(crosses_itself({{0, 0}, {2, 0}, {1, 1}, {1, -1}}, {0, 0}, 0));
  EXPECT_FALSE(crosses_itself({{0, 0}, {2, 0}, {2, 1}, {1, 0.5}}, {0, 0}, 0));
  EXPECT_TRUE(crosses_itself({{0, 0}, {2, 0}, {2, 1}, {1, 0.5}}, {0, 0}, 5)) << "where it goes on straight";
  // The first piece continues to the left, not along the chord between its ends' neighbours.
  EXPECT_FALSE(crosses_itself({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, -2}, {-1.5, -2}}, {0, 0}, 5));
  EXPECT_TRUE(crosses_itself({{0, 0}, {1, 1}, {2, 1}, {2, -2}, {-1.5, -2}}, {0, 0}, 5));
  EXPECT_THROW(cut(box(), std::vector<Knife>{stroke_knife({{0, 0}, {0.02, 0}, {0.02, 0.01}, {0.01, 0.005}})}), Error);
}

/// A file in a folder that is removed afterwards.
class StrokeFile : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "knife.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg">
      <path id="wave" d="M -10,-20 L 0,-25 10,-20"/>
      <path id="loop" d="M 0,0 L 20,0 10,10 10,-10"/>
      <path id="closed" d="M 0,0 L 20,0 10,10 Z"/>
      <path id="two" d="M 0,0 L 20,0 M 10,10 L 10,20"/>
      <path id="empty" d=""/>
    </svg>)";
  }

  std::string message(const std::string& text, ExitStatus status) {
    try {
      parse_knife(text, folder_.path());
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), status) << text;
      return error.what();
    }
    ADD_FAILURE() << text << " is accepted";
    return {};
  }

  const TemporaryFolder folder_;
};

TEST_F(StrokeFile, IsReadInMillimetresWithYUpwards) {
  const auto points = [&](const std::string& text) {
    return std::get<StrokeKnife>(std::get<PlaneCut>(parse_knife(text, folder_.path()).cut)).points;
  };
  ASSERT_EQ(points("stroke:knife.svg#wave").size(), 3u);
  EXPECT_NEAR(points("stroke:knife.svg#wave")[1].y, 0.025, 1e-9);
  EXPECT_NEAR(points("stroke:knife.svg#wave,scale=2mm")[0].x, -0.02, 1e-9);
}

TEST_F(StrokeFile, IsReadAsASketchReadsIt) {
  std::ofstream(folder_ / "habits.svg") << R"(<svg xmlns="http://www.w3.org/2000/svg"
        xmlns:xlink="http://www.w3.org/1999/xlink">
      <path id="line" d="M -10,-20 L 0,-25 10,-20"/>
      <use id="clone" xlink:href="#line" x="0" y="5"/>
      <path id="pen" d="M -10,-20 L 0,-25 10,-20 M 10,-20"/>
      <path id="twice" d="M 0,0 L 1,1"/>
      <g><path id="twice" d="M 0,0 L 1,2"/></g>
      <defs><path id="line" d="M 0,0 L 1,1"/></defs>
    </svg>)";
  const auto points = [&](const std::string& text) {
    return std::get<StrokeKnife>(std::get<PlaneCut>(parse_knife(text, folder_.path()).cut)).points;
  };
  ASSERT_EQ(points("stroke:habits.svg#clone").size(), 3u);
  EXPECT_NEAR(points("stroke:habits.svg#clone")[1].y, 0.02, 1e-9);
  EXPECT_EQ(points("stroke:habits.svg#pen"), points("stroke:habits.svg#line"));
  const std::string told = message("stroke:habits.svg#twice", ExitStatus::bad_data);
  EXPECT_THAT(told, testing::HasSubstr("habits.svg:7:"));
  EXPECT_THAT(told, testing::HasSubstr("drawn 2 times, first at " + (folder_ / "habits.svg") + ":6:"));
}

TEST_F(StrokeFile, SaysWhatIsWrongAndWhere) {
  EXPECT_THAT(message("stroke:knife.svg#loop", ExitStatus::bad_data), testing::HasSubstr("crosses itself"));
  EXPECT_THAT(message("stroke:knife.svg#loop", ExitStatus::bad_data), testing::HasSubstr("knife.svg:3:"));
  EXPECT_THAT(message("stroke:knife.svg#closed", ExitStatus::bad_data), testing::HasSubstr("closed"));
  EXPECT_THAT(message("stroke:knife.svg#two", ExitStatus::bad_data), testing::HasSubstr("not one line"));
  EXPECT_THAT(message("stroke:knife.svg#empty", ExitStatus::bad_data), testing::HasSubstr("\"empty\" is empty"));
  EXPECT_THAT(message("stroke:knife.svg#wvae", ExitStatus::bad_data), testing::HasSubstr("no path"));
  message("stroke:other.svg#wave", ExitStatus::input_missing);
  message("stroke:knife.svg", ExitStatus::usage);
  message("stroke:#wave", ExitStatus::usage);
  message("stroke:knife.svg#", ExitStatus::usage);
  message("stroke:knife.svg#wave,scale=0mm", ExitStatus::usage);
  message("stroke:knife.svg#wave,turn=3", ExitStatus::usage);
}

}  // namespace
}  // namespace pomona
