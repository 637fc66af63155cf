#include "generator/surface/sheets.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "generator/surface/bodies.h"
#include "generator/surface/file/surface_file.h"
#include "generator/surface/sweep/sweep.h"
#include "tests/shapes/shapes.h"
#include "tests/surface/sketches.h"

namespace pomona {
namespace {

using namespace shapes;

Paint blurred(Paint paint, float blur) {
  paint.blur = blur;
  return paint;
}

TEST(Sheets, WithoutBlurNothingChanges) {
  const DiffusionSurfaces ball = hollow_ball(1, 0.5, 4);
  const DiffusionSurfaces split = sheets(ball);
  EXPECT_EQ(split.triangle_count(), ball.triangle_count());
  EXPECT_EQ(split.vertex_count(), ball.vertex_count());
  EXPECT_EQ(signed_volume(split), signed_volume(ball));
}

TEST(Sheets, NotesOfTheFileStay) {
  DiffusionSurfaces ball = sphere(1, 4, blurred({}, 0.05f));
  ball.notes = {"a face is left out"};
  EXPECT_EQ(sheets(ball).notes, ball.notes);
}

TEST(Sheets, AnInnerSurfacePartsIntoTwoThatAreBlurAway) {
  const DiffusionSurfaces ball = sphere(1, 16, blurred({}, 0.05f));
  const DiffusionSurfaces split = sheets(ball);
  ASSERT_EQ(split.triangle_count(), 2 * ball.triangle_count());
  for (std::size_t v = 0; v < split.vertex_count(); ++v) {
    const bool front = v < ball.vertex_count();
    EXPECT_NEAR(glm::length(split.position[v]), front ? 1.05 : 0.95, 2e-4);
    EXPECT_EQ(split.front_color[v], front ? Paint().front : Paint().back);
    EXPECT_EQ(split.back_color[v], split.front_color[v]);
    EXPECT_EQ(split.blur[v], 0);
  }
  const std::size_t last = split.triangle_count() - 1;
  EXPECT_EQ(split.part_names[static_cast<std::size_t>(split.front_part[0])], "skin");
  EXPECT_EQ(split.back_part[0], split.front_part[0]);
  EXPECT_EQ(split.part_names[static_cast<std::size_t>(split.front_part[last])], "flesh");
  EXPECT_EQ(split.surface_names, ball.surface_names);
}

TEST(Sheets, ASkinStaysAndItsVisibleSideMovesInwards) {
  const DiffusionSurfaces ball = sphere(1, 16, blurred(skin_paint(), 0.1f));
  for (const DiffusionSurfaces& skin : {ball, turned_inside_out(ball)}) {
    const DiffusionSurfaces split = sheets(skin);
    ASSERT_EQ(split.triangle_count(), 2 * ball.triangle_count());
    const std::size_t skin_triangles = ball.triangle_count();
    for (std::size_t i = 0; i < split.triangle_count(); ++i) EXPECT_EQ(split.is_boundary(i), i < skin_triangles);
    for (std::size_t v = 0; v < split.vertex_count(); ++v) {
      const bool stays = v < ball.vertex_count();
      EXPECT_NEAR(glm::length(split.position[v]), stays ? 1.0 : 0.9, 2e-4);
      EXPECT_EQ(split.front_color[v], stays ? Paint().front : Paint().back);
      EXPECT_EQ(split.back_color[v], split.front_color[v]);
    }
    EXPECT_EQ(find_bodies(split).bodies.at(0).volume, find_bodies(skin).bodies.at(0).volume);
  }
}

TEST(Sheets, OpenRimsStayTogether) {
  const DiffusionSurfaces sheet = open_sheet(1, 0, 8, blurred({}, 0.02f));
  const DiffusionSurfaces split = sheets(sheet);
  for (std::size_t v = 0; v < split.vertex_count(); ++v) {
    const glm::vec3& p = split.position[v];
    const bool rim = std::max(std::fabs(p.x), std::fabs(p.z)) > 0.499f;
    EXPECT_FLOAT_EQ(std::fabs(p.y), rim ? 0.0f : 0.02f);
  }
}

TEST(Sheets, TinyBlurLeavesOneSurface) {
  EXPECT_EQ(sheets(sphere(1, 4, blurred({}, 1e-7f))).triangle_count(), sphere(1, 4).triangle_count());
}

TEST(Sheets, BlurStopsShortOfFoldingOver) {
  // A blur wider than the ball: the inner sheet must stay a smaller ball, front outside.
  const DiffusionSurfaces split = sheets(sphere(0.01, 8, blurred({}, 0.5f)));
  DiffusionSurfaces inner = split;
  inner.triangle.erase(inner.triangle.begin(),
                       inner.triangle.begin() + static_cast<std::ptrdiff_t>(split.triangle_count() / 2));
  EXPECT_GT(signed_volume(inner), 0.2 * signed_volume(sphere(0.01, 8)));

  // A cup with sharp edges and walls of 2 cm.
  SurfaceSketch cup = sketches::around_axis(
      {{{0, 0}, {0.05, 0}, {0.05, 0.1}, {0.03, 0.1}, {0.03, 0.02}, {0, 0.02}}, false}, sketches::circle(0.05));
  cup.blur.along = Ramp<double>::constant(0.004);
  const DiffusionSurfaces swept = sheets(sweep(sketches::fruit({cup})));
  const std::size_t half = swept.triangle_count() / 2;
  std::size_t turned = 0;
  for (std::size_t i = 0; i < half; ++i) {
    const auto normal = [&](std::size_t triangle) {
      const glm::uvec3 t = swept.triangle[triangle];
      const glm::dvec3 a(swept.position[t.x]);
      return glm::cross(glm::dvec3(swept.position[t.y]) - a, glm::dvec3(swept.position[t.z]) - a);
    };
    if (glm::dot(normal(i), normal(half + i)) < 0) ++turned;
  }
  EXPECT_EQ(turned, 0u);
}

/// Only one sheet of a skin moves: into the ball, where it must stop, or out of a hollow, where it never folds.
TEST(Sheets, ASkinsBlurStopsWhereItWouldFoldAndNowhereElse) {
  const DiffusionSurfaces ball = sphere(0.01, 8, blurred(skin_paint(), 0.5f));
  for (const DiffusionSurfaces& skin : {ball, turned_inside_out(ball)}) {
    DiffusionSurfaces inner = sheets(skin);
    inner.triangle.erase(inner.triangle.begin(),
                         inner.triangle.begin() + static_cast<std::ptrdiff_t>(skin.triangle_count()));
    const double share = signed_volume(inner) / signed_volume(skin);
    EXPECT_GT(share, 0.05) << "it has passed through the middle";
    EXPECT_LT(share, 0.9);
  }

  DiffusionSurfaces hollow = ball;
  std::swap(hollow.front_hidden, hollow.back_hidden);
  const DiffusionSurfaces split = sheets(hollow);
  for (std::size_t v = hollow.vertex_count(); v < split.vertex_count(); ++v)
    EXPECT_NEAR(glm::length(split.position[v]), 0.51, 0.01);
}

TEST(Sheets, WhereBoundaryTurnsInnerVerticesAreDoubledAndBlurIsNone) {
  // A sheet whose left half is skin.
  DiffusionSurfaces sheet = open_sheet(1, 0, 8, blurred({}, 0.02f));
  for (std::size_t v = 0; v < sheet.vertex_count(); ++v) sheet.front_hidden[v] = sheet.position[v].x < 0.01f ? 1 : 0;
  const std::size_t boundary = [&] {
    std::size_t count = 0;
    for (std::size_t i = 0; i < sheet.triangle_count(); ++i) count += sheet.is_boundary(i) ? 1 : 0;
    return count;
  }();
  const DiffusionSurfaces split = sheets(sheet);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < split.triangle_count(); ++i) kept += split.is_boundary(i) ? 1 : 0;
  EXPECT_EQ(kept, boundary);
  EXPECT_GT(boundary, 0u);
  for (const glm::vec3& p : split.position) {
    if (std::fabs(p.x) < 0.01f) {
      EXPECT_EQ(p.y, 0);
    }
    EXPECT_LE(std::fabs(p.y), 0.0201f);
    if (p.x < -0.01f) {
      EXPECT_LE(p.y, 0);
    }
  }
}

TEST(Sheets, MakingThemAgainChangesNothingNorDoesAFile) {
  const DiffusionSurfaces fruit =
      joined(sphere(1, 6, blurred(skin_paint(), 0.05f)),
             joined(sphere(0.6, 5, blurred({}, 0.04f)), open_sheet(0.4, 0, 4, blurred({}, 0.01f))));
  const std::string bytes = write_surfaces(sheets(fruit));
  EXPECT_EQ(write_surfaces(sheets(sheets(fruit))), bytes);
  EXPECT_EQ(write_surfaces(sheets(parse_surfaces(bytes, "sheets.ply"))), bytes);
}

TEST(Sheets, DegenerateTrianglesAreHarmless) {
  DiffusionSurfaces ball = sphere(1, 3, blurred({}, 0.1f));
  ball.triangle[0].y = ball.triangle[0].x;
  ball.position[5] = ball.position[6];
  for (const glm::vec3& p : sheets(ball).position) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  EXPECT_EQ(sheets({}).triangle_count(), 0u);
}

}  // namespace
}  // namespace pomona
