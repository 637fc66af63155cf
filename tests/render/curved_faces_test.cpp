// Cut faces that are not flat: no lines between their facets, in space and on paper.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/knife/parse_knife.h"
#include "generator/piece/solid.h"
#include "render/picture/section_ink.h"
#include "render/picture/section_raster.h"
#include "render/strokes/solid_edges.h"
#include "tests/cut/solid_shapes.h"
#include "tests/shapes/shapes.h"
#include "tests/shapes/sliced.h"

namespace pomona {
namespace {

DiffusionSurfaces ball_fruit() { return shapes::sphere(0.05, 10, shapes::skin_paint()); }

std::vector<SharpEdge> lines_of(const Knife& knife, LineKind kind) {
  std::vector<SharpEdge> found;
  for (const Solid& solid : shapes::sliced(ball_fruit(), {knife}).pieces) {
    for (const SharpEdge& edge : solid_edges(solid).sharp) {
      if (edge.kind == kind) found.push_back(edge);
    }
  }
  return found;
}

TEST(CurvedFaces, HaveARimAndNoRidges) {
  for (const Knife& knife :
       {shapes::solid_knife(shapes::ball({0.04, 0.003, 0.002}, 0.02, 8)), parse_knife("crinkle:30mm")}) {
    EXPECT_TRUE(lines_of(knife, LineKind::ridge).empty());
    EXPECT_GT(lines_of(knife, LineKind::rim).size(), 40u);
  }
}

TEST(CurvedFaces, HaveRidgesAtCreases) {
  // A rod that ends within the fruit: at least the 48 edges of its end, which the fruit does not cut, on both sides.
  const auto ridges =
      lines_of(shapes::solid_knife(shapes::rod({0.003, -0.02, 0.002}, 0.012, 0.2, 48)), LineKind::ridge);
  EXPECT_GE(ridges.size(), 2 * 48u);
  EXPECT_LT(ridges.size(), 2 * 200u);
}

constexpr glm::dvec3 knob_middle(0, 0.045, 0);

/// A ball with a smaller one half sunk in it, like a stem; all of one colour, except for the inside of the knob.
std::vector<Solid> halves_of_ball_with_knob(const Color& within_knob) {
  shapes::Paint ball = shapes::skin_paint(), knob = ball;
  ball.front = knob.front = ball.back;
  knob.name = knob.back_part = "knob";
  knob.back = within_knob;
  DiffusionSurfaces surfaces = shapes::nested_spheres(0.05, 0.015, 10, ball, knob);
  for (glm::vec3& p : surfaces.position) {
    if (glm::length(p) < 0.02f) p += glm::vec3(knob_middle);
  }
  return shapes::sliced(surfaces, {parse_knife("half")}).pieces;
}

/// The opacity of the cut face's lines on the knob's outline within the ball.
std::vector<float> sunk_lines(const std::vector<Solid>& pieces) {
  std::vector<float> opacity;
  for (const Solid& solid : pieces) {
    for (const SharpEdge& edge : solid_edges(solid).sharp) {
      const glm::dvec3 middle = 0.5 * glm::dvec3(solid.mesh.position[edge.a] + solid.mesh.position[edge.b]);
      if (glm::length(middle) < 0.0485 && std::fabs(middle.z) < 1e-6) opacity.push_back(edge.opacity);
    }
  }
  return opacity;
}

/// Overlapping bodies are one body, so the outline of a sunk one is an ordinary line between colours.
TEST(FlatFaces, HaveALineAroundWhatIsSunkInThemOnlyWhereColorsDiffer) {
  const std::vector<float> contrasting = sunk_lines(halves_of_ball_with_knob(Color(0.2f, 0.1f, 0.05f)));
  EXPECT_GT(contrasting.size(), 40u);
  for (const float opacity : contrasting) EXPECT_GT(opacity, 0.5f);
  for (const float opacity : sunk_lines(halves_of_ball_with_knob(shapes::skin_paint().back))) EXPECT_LT(opacity, 0.1f);
}

TEST(CurvedFaces, OfAWaveHaveOneLineAroundThem) {
  const CrossSection section = cut(ball_fruit(), std::vector{parse_knife("crinkle:40mm")}).section;
  std::set<int> strokes;
  for (const CutFace& face : section.faces) strokes.insert(face.stroke);
  ASSERT_GT(section.faces.size(), 2 * strokes.size()) << "facets";
  EXPECT_EQ(section_lines(section, lay_out(section, {400, 300}, 10)).size(), strokes.size());
}

TEST(CurvedFaces, TurnNoTriangleAway) {
  for (const ClosedSurface& solid :
       {shapes::ball({0.01, 0.003, 0.002}, 0.02, 8), shapes::rod({0.003, -0.1, 0.002}, 0.012, 0.2, 32)}) {
    const CrossSection section = cut(ball_fruit(), std::vector{shapes::solid_knife(solid)}).section;
    EXPECT_EQ(section.faces.size(), 2u) << "front and back";
    const std::vector<PlacedFace> faces = lay_out(section, {400, 300}, 10);
    for (std::size_t t = 0; t < section.triangle.size(); ++t) {
      const PlacedFace& face = faces[static_cast<std::size_t>(section.cut[t])];
      const glm::uvec3& c = section.triangle[t];
      const glm::dvec2 a = face.to_paper(section.position[c.x]), b = face.to_paper(section.position[c.y]) - a,
                       d = face.to_paper(section.position[c.z]) - a;
      EXPECT_LT(b.x * d.y - b.y * d.x, 1e-3) << "counter-clockwise, with y down";
    }
  }
}

/// Each sample of a pixel counts once, even if a face overlaps itself.
TEST(CurvedFaces, AreNotBrighterWhereTheyLieOnThemselves) {
  CrossSection section;
  section.faces.resize(1);
  for (const float z : {0.0f, 0.01f}) {
    for (const glm::vec3& p : {glm::vec3(0, 0, z), glm::vec3(1, 0, z), glm::vec3(0, 1, z)}) {
      section.position.push_back(p);
      section.color.emplace_back(0.5f);
    }
  }
  section.triangle = {{0, 1, 2}, {3, 4, 5}};
  section.cut = {0, 0};
  int covered = 0;
  const std::vector<PlacedFace> faces = lay_out(section, {40, 40}, 2);
  const SectionRaster raster(section, faces, 40, 40);
  for (std::size_t band = 0; band < raster.bands(); ++band) {
    for (const SectionPixel& pixel : raster.pixels(band)) {
      EXPECT_NEAR(pixel.color_sum.x, 0.5 * pixel.samples, 1e-6);
      covered += pixel.samples;
    }
  }
  EXPECT_GT(covered, 0);
}

}  // namespace
}  // namespace pomona
