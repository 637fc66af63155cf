// Points lie where the field needs them: many where colours differ across a gap, none where they do not.
#include "generator/cut/section/size_field.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace pomona {
namespace {

const SizeLimits limits{.coarsest = 0.25, .finest = 0.01, .grading = 0.35, .contrast = 0.07};

/// Two rows of segments, one above the other, that face each other with these colours.
std::vector<SizeSource> facing_rows(double gap, const Color& below, const Color& above, double step = 0.05) {
  std::vector<SizeSource> sources;
  for (int i = 0; i < 40; ++i) {
    const double x = step * i;
    sources.push_back({{x, 0}, {x + step, 0}, 3 * step, below, below});
    sources.push_back({{x, gap}, {x + step, gap}, 3 * step, above, above});
  }
  return sources;
}

std::size_t points_between(double gap, const Color& below, const Color& above) {
  return SizeField(facing_rows(gap, below, above), limits).samples().size();
}

TEST(SizeField, PutsMorePointsBetweenColoursThatDifferMore) {
  const Color grey(0.5f);
  const std::size_t equal = points_between(0.2, grey, grey), close = points_between(0.2, grey, Color(0.55f)),
                    apart = points_between(0.2, grey, Color(0.8f)), far = points_between(0.2, Color(0), Color(1));
  EXPECT_EQ(equal, close);
  EXPECT_GT(apart, close);
  EXPECT_GT(far, apart);
}

TEST(SizeField, TurnsTheFacingSideToTheGap) {
  // Only the sides that face away from the gap differ.
  std::vector<SizeSource> sources = facing_rows(0.2, Color(0.5f), Color(0.5f));
  for (SizeSource& s : sources) (s.a.y == 0 ? s.right : s.left) = Color(s.a.y == 0 ? 0.0f : 1.0f);
  EXPECT_EQ(SizeField(sources, limits).samples().size(), points_between(0.2, Color(0.5f), Color(0.5f)));
  for (SizeSource& s : sources) std::swap(s.left, s.right);
  EXPECT_GT(SizeField(sources, limits).samples().size(), points_between(0.2, Color(0.5f), Color(0.5f)));
}

TEST(SizeField, LaysOneRowAlongANarrowGap) {
  const double gap = 0.03;  // three finest lengths
  const std::vector<glm::dvec2> points = SizeField(facing_rows(gap, Color(0), Color(1)), limits).samples();
  ASSERT_FALSE(points.empty());
  for (const glm::dvec2& p : points) EXPECT_NEAR(p.y, gap / 2, 0.1 * gap);
  EXPECT_NEAR(static_cast<double>(points.size()), 2.0 / (0.8 * gap), 0.35 * 2.0 / (0.8 * gap));
  EXPECT_TRUE(SizeField(facing_rows(0.02, Color(0), Color(1)), limits).samples().empty()) << "too narrow to resolve";
}

TEST(SizeField, LooksThroughLinesInWhichPlanesMeet) {
  std::vector<SizeSource> sources = facing_rows(0.4, Color(0), Color(1));
  const std::size_t without = SizeField(sources, limits).samples().size();
  SizeSource line{{1, 0}, {1, 0.4}, 0.2, {}, {}};
  line.has_color = false;
  sources.push_back(line);
  const auto with = static_cast<double>(SizeField(sources, limits).samples().size());
  EXPECT_NEAR(with, static_cast<double>(without), 0.2 * static_cast<double>(without));
}

TEST(SizeField, KeepsPointsApartAndOffTheSources) {
  const std::vector<SizeSource> sources = facing_rows(0.3, Color(0), Color(1));
  const SizeField field(sources, limits);
  const std::vector<glm::dvec2> points = field.samples();
  ASSERT_GT(points.size(), 50u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_GT(std::min(points[i].y, 0.3 - points[i].y), 0.4 * field.at(points[i]));
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(glm::distance(points[i], points[j]), 0.5 * field.at(points[i]));
  }
}

TEST(SizeField, OfNothingIsCoarse) {
  const SizeField field({}, limits);
  EXPECT_EQ(field.at({0.3, 0.4}), limits.coarsest);
  EXPECT_TRUE(field.samples().empty());
}

}  // namespace
}  // namespace pomona
