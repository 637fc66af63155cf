// Pieces laid out for a picture lie on the table, apart, and show their cut faces, their skin and their thickness.
#include "generator/scene/lay_out.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/knife/parse_knife.h"
#include "generator/mesh/box.h"
#include "generator/scene/piece_outline.h"
#include "generator/scene/side_areas.h"
#include "generator/scene/stand.h"
#include "generator/scene/table_pose.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

Scene pieces_of(const DiffusionSurfaces& fruit, const std::vector<std::string>& knives) {
  std::vector<Knife> parsed;
  for (const std::string& text : knives) parsed.push_back(parse_knife(text));
  return gathered(shapes::sliced(fruit, parsed).pieces);
}

DiffusionSurfaces ball() { return shapes::moved(shapes::sphere(0.03, 12, shapes::skin_paint()), {0, 0.03, 0}); }

/// A bar as long as a cucumber, with its axis up.
DiffusionSurfaces bar() { return shapes::box({-0.02, 0, -0.02}, {0.02, 0.18, 0.02}, 3, shapes::skin_paint()); }

std::vector<glm::dvec3> placed_points(const Scene& scene, const Instance& instance) {
  std::vector<glm::dvec3> points;
  for (const glm::vec3& p : scene.solids[static_cast<std::size_t>(instance.solid)].mesh.position)
    points.push_back(instance.pose.rotation * glm::dvec3(p) + instance.pose.translation);
  return points;
}

/// The area vectors of the flat cut faces in their pose.
std::vector<glm::dvec3> face_vectors(const Scene& scene, const Instance& instance) {
  const Solid& solid = scene.solids[static_cast<std::size_t>(instance.solid)];
  const std::vector<glm::dvec3> at = placed_points(scene, instance);
  std::map<std::int32_t, std::pair<glm::dvec3, double>> faces;
  for (std::size_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    if (solid.mesh.cut_face[t] < 0) continue;
    const glm::uvec3& v = solid.mesh.triangle[t];
    const glm::dvec3 vector = 0.5 * glm::cross(at[v.y] - at[v.x], at[v.z] - at[v.x]);
    auto& [sum, area] = faces.try_emplace(solid.mesh.cut_face[t], glm::dvec3(0), 0.0).first->second;
    sum += vector;
    area += glm::length(vector);
  }
  std::vector<glm::dvec3> flat;
  for (const auto& [index, of] : faces)
    if (of.second > 0 && glm::length(of.first) > 0.98 * of.second) flat.push_back(of.first);
  return flat;
}

const std::vector<std::vector<std::string>> ways_to_cut{
    {"half"}, {"wedges:6"}, {"slices:8mm"}, {"dice:15mm"}, {"ball:24mm"}, {"bite:25mm"}, {"core:15mm", "half"}};

TEST(LaidOut, NoPieceFloatsOrIsSunk) {
  for (const std::vector<std::string>& knives : ways_to_cut) {
    const Scene table = laid_out(pieces_of(ball(), knives));
    ASSERT_GE(table.instances.size(), 2u);
    EXPECT_TRUE(table.ground);
    for (const Instance& instance : table.instances)
      EXPECT_NEAR(box_around(placed_points(table, instance)).low.y, 0, 1e-9) << knives[0] << ' ' << instance.name;
  }
}

TEST(LaidOut, PiecesLieApart) {
  for (const std::vector<std::string>& knives : ways_to_cut) {
    const Scene table = laid_out(pieces_of(ball(), knives));
    std::vector<Box<double>> boxes;
    for (const Instance& instance : table.instances) boxes.push_back(box_around(placed_points(table, instance)));
    // In turned rows, boxes along the axes are no measure.
    if (knives[0] == "wedges:6") continue;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(boxes[i].meets(boxes[j])) << knives[0] << ' ' << i << ' ' << j;
  }
}

/// The arms of a star have much skin beside the cut.
TEST(LaidOut, AHalfShowsItsFaceHoweverSmall) {
  const DiffusionSurfaces column = shapes::box({-0.006, 0, -0.03}, {0.006, 0.05, 0.03}, 4, shapes::skin_paint());
  const Scene table = laid_out(pieces_of(column, {"across"}));
  for (const Instance& instance : table.instances) {
    double facing = 0;
    for (const glm::dvec3& face : face_vectors(table, instance))
      facing = std::max(facing, glm::dot(glm::normalize(face), eye_over_table()));
    EXPECT_GT(facing, 0.5) << instance.name;
  }
}

/// Of half an empty shell, as of half a cabbage, a knife meets edges alone.
TEST(LaidOut, AHalfOfThinWallsLiesOnItsBack) {
  const Scene halves = pieces_of(shapes::hollow_ball(0.03, 0.0295, 12), {"half"});
  ASSERT_EQ(halves.solids.size(), 2u);
  for (const Solid& solid : halves.solids) {
    const SideAreas areas(solid);
    EXPECT_LT(areas.cut(), 0.02 * areas.skin());
    EXPECT_TRUE(table_pose(solid).on_back);
  }
}

/// The round side of a peeled half is a cut face, too; the flat one must be shown.
TEST(LaidOut, APeeledHalfShowsItsFlatFace) {
  const Scene table = laid_out(pieces_of(ball(), {"peel:2mm", "half"}));
  for (const Instance& instance : table.instances) {
    glm::dvec3 widest(0);
    for (const glm::dvec3& face : face_vectors(table, instance))
      if (glm::length(face) > glm::length(widest)) widest = face;
    EXPECT_GT(glm::dot(glm::normalize(widest), eye_over_table()), 0.5) << instance.name;
  }
}

/// Only strips of peel hang, and these not in simulators, whose masses are of the pieces as they were cut.
TEST(LaidOut, OnlyPeelsHangAndOnlyInPictures) {
  Scene pieces = pieces_of(ball(), {"peel:2mm,spiral=12mm"});
  const auto changes = [&](const Scene& table) {
    return std::count_if(table.solids.begin(), table.solids.end(), [&, i = std::size_t{0}](const Solid& solid) mutable {
      return solid.mesh.position != pieces.solids[i++].mesh.position;
    });
  };
  EXPECT_EQ(changes(laid_out(pieces)), 1);
  EXPECT_EQ(changes(laid_out(pieces, 1, Peels::as_cut)), 0);
  for (Solid& solid : pieces.solids) solid.origin.knives = {"slices:5"};
  EXPECT_EQ(changes(laid_out(pieces)), 0) << "a leaf of a cabbage winds about the axis, too";
}

/// Each half of a ball shows most of its face, and some skin.
TEST(LaidOut, AHalfShowsItsFaceAndItsSkin) {
  const Scene table = laid_out(pieces_of(ball(), {"half"}));
  const double disc = pi * 0.03 * 0.03;
  for (const Instance& instance : table.instances) {
    const glm::dvec3 eye = glm::conjugate(instance.pose.rotation) * eye_over_table();
    const SideAreas::Seen seen = SideAreas(table.solids[static_cast<std::size_t>(instance.solid)]).from(eye);
    EXPECT_GT(seen.cut, 0.75 * disc);
    EXPECT_LT(seen.cut, 0.95 * disc) << "from straight above one sees no thickness";
    EXPECT_GT(seen.skin, 0.05 * disc);
  }
}

/// A prism with a narrow edge at one side: by itself the half with the edge would roll to one of its slopes, and be
/// drawn smaller than the other.
DiffusionSurfaces prism() {
  DiffusionSurfaces fruit = shapes::box({-0.03, 0, -0.03}, {0.03, 0.07, 0.03}, 6, shapes::skin_paint());
  for (glm::vec3& p : fruit.position) p.x *= (p.z + 0.032f) / 0.062f;
  return fruit;
}

TEST(LaidOut, HalvesOfOneFruitLieAlike) {
  const Scene halves = pieces_of(prism(), {"half"});
  ASSERT_EQ(halves.instances.size(), 2u);
  const auto axis_alone = [&](std::size_t i) { return table_pose(halves.solids[i]).rotation * glm::dvec3(0, 1, 0); };
  EXPECT_GT(glm::distance(axis_alone(0), axis_alone(1)), 0.05) << "each by itself lies otherwise";
  const Scene table = laid_out(halves);
  std::vector<glm::dvec3> face, axis;
  for (const Instance& instance : table.instances) {
    const std::vector<glm::dvec3> faces = face_vectors(table, instance);
    ASSERT_EQ(faces.size(), 1u);
    face.push_back(glm::normalize(faces[0]));
    axis.push_back(instance.pose.rotation * glm::dvec3(0, 1, 0));
    EXPECT_NEAR(box_around(placed_points(table, instance)).low.y, 0, 1e-9);
  }
  EXPECT_LT(glm::distance(face[0], face[1]), 1e-6);
  EXPECT_LT(glm::distance(axis[0], axis[1]), 1e-6);
}

/// A mountain with flat ground stands on it and turns its face to the eye.
TEST(LaidOut, WhatHasFlatGroundUnderItStands) {
  const DiffusionSurfaces block = shapes::box({-0.05, 0, -0.05}, {0.05, 0.03, 0.05}, 4, shapes::skin_paint());
  const Scene halves = pieces_of(block, {"half"});
  EXPECT_TRUE(stands_on_flat_ground(halves.solids[0]));
  EXPECT_FALSE(stands_on_flat_ground(pieces_of(ball(), {"across"}).solids[0])) << "a cut face is no ground";
  EXPECT_FALSE(stands_on_flat_ground(pieces_of(ball(), {"half"}).solids[0]));
  const Scene table = laid_out(halves);
  for (const Instance& instance : table.instances) {
    EXPECT_NEAR((instance.pose.rotation * glm::dvec3(0, 1, 0)).y, 1, 1e-9) << instance.name;
    EXPECT_GT(glm::dot(glm::normalize(face_vectors(table, instance)[0]), eye_beside_table()), 0.85) << instance.name;
  }
}

/// Halves of a cake or a mountain, in a picture that is hardly wider than high: the nearer would hide the other.
TEST(LaidOut, WideHalvesThatStandAreSideBySide) {
  const DiffusionSurfaces cake = shapes::box({-0.09, 0, -0.09}, {0.09, 0.05, 0.09}, 4, shapes::skin_paint());
  const Scene table = laid_out(pieces_of(cake, {"half"}), 4.0 / 3);
  ASSERT_EQ(table.instances.size(), 2u);
  const Box<double> one = box_around(placed_points(table, table.instances[0]));
  const Box<double> other = box_around(placed_points(table, table.instances[1]));
  EXPECT_TRUE(one.high.x < other.low.x || other.high.x < one.low.x);
  EXPECT_NEAR(one.high.z, other.high.z, 1e-9) << "equally near, so at one scale";
}

TEST(LaidOut, WedgesLieOnTheirSides) {
  const Scene table = laid_out(pieces_of(ball(), {"wedges:6"}));
  for (const Instance& instance : table.instances) {
    double lying = 0, facing = 0;
    for (const glm::dvec3& face : face_vectors(table, instance)) {
      lying = std::max(lying, -glm::normalize(face).y);
      facing = std::max(facing, glm::dot(glm::normalize(face), eye_over_table()));
    }
    EXPECT_GT(lying, 1 - 1e-9) << instance.name << ": to the bit, not as well as it would balance";
    EXPECT_GT(facing, 0.6) << instance.name << " turns its face away";
  }
}

TEST(LaidOut, SlicesLieFlat) {
  const Scene table = laid_out(pieces_of(ball(), {"slices:6mm"}));
  for (const Instance& instance : table.instances) {
    double up = 0;
    for (const glm::dvec3& face : face_vectors(table, instance)) up = std::max(up, glm::normalize(face).y);
    EXPECT_GT(up, 0.97) << instance.name;
  }
}

void expect_diagonal(const Scene& table) {
  for (const Instance& instance : table.instances) {
    const glm::dvec3 axis = instance.pose.rotation * glm::dvec3(0, 1, 0);
    EXPECT_NEAR(std::fabs(glm::dot(axis, diagonal_on_table())), 1, 0.02) << instance.name;
    EXPECT_NEAR(box_around(placed_points(table, instance)).low.y, 0, 1e-9);
  }
}

TEST(LaidOut, WhatIsLongLiesDiagonally) {
  expect_diagonal(laid_out(pieces_of(bar(), {"half"})));
  expect_diagonal(laid_out(pieces_of(bar(), {})));
  Scene seen = pieces_of(bar(), {});
  seen.view = fitted_view(seen, {0, 0.5, 1});
  expect_diagonal(standing(seen));
}

TEST(LaidOut, AWholeFruitStandsAsItGrew) {
  const Scene table = laid_out(pieces_of(ball(), {}));
  EXPECT_GT((table.instances[0].pose.rotation * glm::dvec3(0, 1, 0)).y, 1 - 1e-9);
}

/// A ball whose lowest tenth is stretched into a root, as thin as a beetroot's or as wide as a cone.
DiffusionSurfaces rooted_ball(double thinness) {
  constexpr double radius = 0.03, begin = -0.9 * radius, length = 0.02;
  DiffusionSurfaces fruit = shapes::sphere(radius, 24, shapes::skin_paint());
  for (glm::vec3& p : fruit.position) {
    if (p.y >= begin) continue;
    const double along = (begin - p.y) / (0.1 * radius);
    p = glm::vec3(thinness * p.x, begin - length * along, thinness * p.z);
  }
  return fruit;
}

TEST(LaidOut, WhatWouldBalanceOnItsRootLiesDown) {
  const auto uprightness = [](const DiffusionSurfaces& fruit) {
    return (table_pose(pieces_of(fruit, {}).solids[0]).rotation * glm::dvec3(0, 1, 0)).y;
  };
  EXPECT_LT(std::fabs(uprightness(rooted_ball(0.1))), 0.7);
  EXPECT_GT(uprightness(rooted_ball(1)), 1 - 1e-9);
}

/// Inner vertices do not change a piece's outline, in any order.
TEST(PieceOutline, IsThatOfTheFarthestVertices) {
  const Solid solid = pieces_of(bar(), {}).solids[0];
  Solid filled = solid;
  for (const glm::vec3& p : solid.mesh.position)
    filled.mesh.position.push_back(glm::mix(glm::vec3(0, 0.09f, 0), p, 0.5f));
  const PieceOutline outline(solid), of_filled(filled);
  for (const glm::dvec3& up :
       {glm::dvec3(0, 1, 0), {0, -1, 0}, {1, 0, 0}, {0, 0, -1}, glm::normalize(glm::dvec3(1, 2, 3))})
    EXPECT_EQ(of_filled.height(up), outline.height(up));
  EXPECT_EQ(of_filled.radius(), outline.radius());
}

/// The bounding box of the scene on a picture of this shape, -1 to 1 to the right and upwards.
Box<double> on_picture(const Scene& scene, const View& view, double aspect) {
  const glm::dvec3 back = glm::normalize(view.eye - view.target);
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), back)), up = glm::cross(back, right);
  const double slope = std::tan(0.5 * view.vertical_field);
  Box<double> filled;
  for (const Instance& instance : scene.instances)
    for (const glm::dvec3& p : placed_points(scene, instance)) {
      const glm::dvec3 away = p - view.eye;
      const double depth = -glm::dot(away, back);
      filled.add({glm::dot(away, right) / (depth * slope * aspect), glm::dot(away, up) / (depth * slope), 0});
    }
  return filled;
}

/// Many pieces fill pictures of any shape: no half of a canvas is empty.
TEST(LaidOut, RowsFillThePicture) {
  const Scene dice = pieces_of(ball(), {"dice:12mm"}), sticks = pieces_of(bar(), {"slices:60mm", "sticks:8mm"});
  for (const Scene* scene : {&dice, &sticks}) {
    for (const double aspect : {0.7, 1.0, 4.0 / 3, 2.0}) {
      const Scene table = laid_out(*scene, aspect);
      const glm::dvec3 filled = on_picture(table, table.view, aspect).size() / 2.0;
      EXPECT_GT(std::max(filled.x, filled.y), 0.9) << aspect;
      EXPECT_GT(std::min(filled.x, filled.y), 0.6) << aspect;
    }
  }
}

/// Scooped balls lie in front of the halves, in rows of their own.
TEST(LaidOut, WhatIsSmallHasRowsOfItsOwn) {
  for (const int balls : {1, 2, 3}) {
    std::vector<std::string> knives{"half"};
    for (int i = 0; i < balls; ++i) knives.push_back("ball:6mm,at=" + std::to_string(12 * i - 12) + "mm,30mm,0");
    const Scene scene = pieces_of(ball(), knives);
    ASSERT_EQ(scene.instances.size(), 2u + 2u * static_cast<std::size_t>(balls));
    const Scene table = laid_out(scene, 4.0 / 3);
    double halves = -1, farthest_ball = 1;  // nearest edge of the halves, and the farthest ball
    for (const Instance& instance : table.instances) {
      Box<double> box;
      for (const glm::dvec3& p : placed_points(table, instance)) box.add(p);
      if (box.size().x > 0.03)
        halves = std::max(halves, box.high.z);
      else
        farthest_ball = std::min(farthest_ball, box.low.z);
    }
    EXPECT_GT(farthest_ball, halves) << balls;
  }
}

/// All corners of a tiny crumb may be at one place.
TEST(LaidOut, APointStandsAsItGrew) {
  Solid point;
  point.mesh.position.assign(3, {0.01f, 0.02f, 0.03f});
  point.mesh.normal.assign(3, {0, 1, 0});
  point.mesh.color.assign(3, Color(0.5f));
  point.mesh.part.assign(3, 0);
  point.mesh.triangle = {{0, 1, 2}};
  point.mesh.cut_face = {-1};
  const TablePose pose = table_pose(point);
  EXPECT_TRUE(pose.as_grown);
  EXPECT_GT((pose.rotation * glm::dvec3(0, 1, 0)).y, 1 - 1e-9);
}

/// Slices of a stalk are specks beside a fruit's; in a row of dice as small as they are, they are pieces.
TEST(LaidOut, SpecksHaveNoPlaceInARow) {
  const auto pieces = [](int large, int small) {
    Scene scene = gathered(std::vector<Solid>(static_cast<std::size_t>(large + small)));
    for (int i = 0; i < large + small; ++i) scene.solids[static_cast<std::size_t>(i)].volume = i < large ? 1e-4 : 1e-8;
    return scene;
  };
  EXPECT_EQ(without_crumbs(pieces(2, 3)).instances.size(), 2u);
  EXPECT_EQ(without_crumbs(pieces(2, 3)).solids.size(), 5u);
  EXPECT_EQ(without_crumbs(pieces(0, 5000)).instances.size(), 5000u);
  Scene open = pieces(2, 1);
  open.solids.back().closed = false;
  EXPECT_EQ(without_crumbs(open).instances.size(), 3u);
}

TEST(LaidOut, NothingIsNothing) { EXPECT_TRUE(laid_out(Scene{}).instances.empty()); }

}  // namespace
}  // namespace pomona
