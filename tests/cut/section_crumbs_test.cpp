// A section without crumbs: small components of a face go, with all that belongs to them, and nothing else moves.
#include "generator/cut/section/section_crumbs.h"

#include <gtest/gtest.h>

namespace pomona {
namespace {

/// Adds a right triangle with legs of this length to a face, with a segment along its first leg.
void add_triangle(CrossSection& section, const glm::vec3& corner, float leg, std::int32_t face) {
  const auto first = static_cast<std::uint32_t>(section.position.size());
  const auto tone = static_cast<float>(first);
  for (const glm::vec3& way : {glm::vec3(0), glm::vec3(leg, 0, 0), glm::vec3(0, leg, 0)}) {
    section.position.push_back(corner + way);
    section.color.emplace_back(tone);
    section.interior.push_back(first % 2);
    section.part.push_back(face);
  }
  section.triangle.emplace_back(first, first + 1, first + 2);
  section.cut.push_back(face);
  section.segments.push_back({.vertex = {first, first + 1}, .surface = static_cast<std::int32_t>(first)});
}

/// One face for each pair of a knife and a stroke.
CrossSection with_faces(const std::vector<std::pair<int, int>>& faces) {
  CrossSection section;
  for (const auto& [knife, stroke] : faces) {
    CutFace face;
    face.knife = knife;
    face.stroke = stroke;
    section.faces.push_back(face);
  }
  return section;
}

TEST(SectionCrumbs, GoWithAllThatBelongsToThem) {
  CrossSection section = with_faces({{0, -1}});
  add_triangle(section, {0, 0, 0}, 1, 0);
  add_triangle(section, {5, 0, 0}, 0.02f, 0);
  add_triangle(section, {9, 0, 0}, 0.03f, 0);
  const CrossSection left = without_crumbs(section);
  ASSERT_EQ(left.triangle.size(), 2u) << "0.0004 of the face goes, 0.0009 stays";
  EXPECT_EQ(left.triangle[1], glm::uvec3(3, 4, 5));
  EXPECT_EQ(left.cut.size(), 2u);
  ASSERT_EQ(left.position.size(), 6u);
  EXPECT_EQ(left.position[3], glm::vec3(9, 0, 0));
  EXPECT_EQ(left.color[3], section.color[6]);
  EXPECT_EQ(left.interior.size(), 6u);
  EXPECT_EQ(left.part.size(), 6u);
  EXPECT_TRUE(left.normal.empty() && left.guide.empty());
  ASSERT_EQ(left.segments.size(), 2u);
  EXPECT_EQ(left.segments[1].surface, 6);
  EXPECT_EQ(left.segments[1].vertex, (std::array<std::uint32_t, 2>{3, 4}));
}

TEST(SectionCrumbs, AreNotWhatTouchesTheFruit) {
  CrossSection section = with_faces({{0, -1}});
  add_triangle(section, {0, 0, 0}, 1, 0);
  add_triangle(section, {1, 0, 0}, 0.01f, 0);
  EXPECT_EQ(without_crumbs(section).triangle, section.triangle);
}

/// The small face of a knife that grazes the fruit is a face, not a crumb; the facets of one stroke are one face.
TEST(SectionCrumbs, AreMeasuredByTheirOwnFace) {
  CrossSection planes = with_faces({{0, -1}, {0, -1}});
  add_triangle(planes, {0, 0, 0}, 1, 0);
  add_triangle(planes, {0, 0, 3}, 0.01f, 1);
  EXPECT_EQ(without_crumbs(planes).triangle.size(), 2u);

  CrossSection stroke = planes;
  for (CutFace& facet : stroke.faces) facet.stroke = 0;
  EXPECT_EQ(without_crumbs(stroke).triangle.size(), 1u);
  stroke.faces[1].stroke = 1;
  EXPECT_EQ(without_crumbs(stroke).triangle.size(), 2u);
}

}  // namespace
}  // namespace pomona
