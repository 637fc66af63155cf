#include "generator/data/drawn_picture.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pomona {
namespace {

namespace fs = std::filesystem;
const fs::path templates = fs::path(POMONA_SOURCE_DIR) / "templates";

DataPlan plan_of(const std::string& rest, int count = 500) {
  const std::string head = "[data]\nformat = 1\nname = \"d\"\nseed = 3\ncount = " + std::to_string(count) + "\n";
  return planned(parse_data(head + rest, "d.toml"),
                 {.find = [](const std::string& name) { return templates / (name + ".toml"); },
                  .all =
                      [] {
                        return std::vector<fs::path>{templates / "cherry.toml", templates / "lemon.toml"};
                      }});
}

const std::string two_kinds =
    "style = [\"ink\", \"photo\"]\n"
    "[scene]\nfruits = [2, 3]\n[view]\nelevation = [30, 60]\nfit = [1, 2]\n"
    "[[fruit]]\nname = \"a\"\ntemplates = \"cherry\"\nknives = [[], \"half\"]\n"
    "[[fruit]]\nname = \"b\"\ntemplates = \"lemon\"\nknives = [\"random:2\"]\npieces = [1, 5]\nripeness = [0.5, 1]\n";

TEST(DrawnPicture, KeepsToTheLaws) {
  const DataPlan plan = plan_of(two_kinds);
  std::set<std::string> styles;
  std::set<std::uint64_t> seeds;
  for (int n = 0; n < plan.data.count; ++n) {
    const DrawnPicture picture = drawn_picture(plan, n);
    styles.insert(picture.style);
    seeds.insert(picture.scene.seed);
    EXPECT_GE(picture.elevation, plan.data.view.elevation.low);
    EXPECT_LE(picture.elevation, plan.data.view.elevation.high);
    EXPECT_LE(picture.scene.seed, std::uint64_t{1} << 53);
    ASSERT_GE(picture.scene.pieces.size(), 2u);
    ASSERT_LE(picture.scene.pieces.size(), 3u);
    for (const PiecesDescription& pieces : picture.scene.pieces) {
      const bool is_lemon = pieces.template_name == "lemon";
      EXPECT_EQ(pieces.ripeness.has_value(), is_lemon && plan.templates[1].fruit.ripeness.declared());
      EXPECT_EQ(pieces.knives.size() == 2, is_lemon);
      EXPECT_LE(pieces.take, is_lemon ? 5 : 1);
    }
  }
  EXPECT_EQ(styles.size(), 2u);
  EXPECT_EQ(seeds.size(), static_cast<std::size_t>(plan.data.count));
}

TEST(DrawnPicture, DoesNotDependOnHowManyThereAre) {
  const DataPlan few = plan_of(two_kinds, 10), many = plan_of(two_kinds, 1000);
  for (int n = 0; n < 10; ++n) {
    const DrawnPicture a = drawn_picture(few, n), b = drawn_picture(many, n);
    EXPECT_EQ(a.scene.seed, b.scene.seed);
    EXPECT_EQ(a.azimuth, b.azimuth);
    EXPECT_EQ(a.style, b.style);
    EXPECT_EQ(a.split, b.split);
    EXPECT_EQ(picture_recipe(few, "p", n), picture_recipe(many, "p", n));
    EXPECT_NE(picture_recipe(few, "p", n), picture_recipe(few, "q", n));
  }
  EXPECT_NE(picture_recipe(few, "p", 0), picture_recipe(few, "p", 1));
}

TEST(DrawnPicture, GivesEachKindItsShareOfThePieces) {
  const DataPlan plan = plan_of(two_kinds, 4000);
  std::map<std::string, int> pieces;
  for (int n = 0; n < plan.data.count; ++n)
    for (const PiecesDescription& one : drawn_picture(plan, n).scene.pieces) pieces[one.template_name] += one.take;
  EXPECT_NEAR(static_cast<double>(pieces["cherry"]) / pieces["lemon"], 1, 0.05);
}

TEST(DrawnPicture, SplitsByItsShares) {
  const DataPlan plan = plan_of("split = [7, 2, 1]\n" + two_kinds, 5000);
  std::map<std::string, int> pictures;
  for (int n = 0; n < plan.data.count; ++n) ++pictures[split_of(plan.data, n)];
  EXPECT_NEAR(pictures["train"], 3500, 100);
  EXPECT_NEAR(pictures["validation"], 1000, 80);
  EXPECT_NEAR(pictures["test"], 500, 60);
}

TEST(DrawnPicture, RandomPlanesMeetTheFruit) {
  const DataPlan plan = plan_of("[[fruit]]\nname = \"b\"\ntemplates = \"lemon\"\nknives = \"random\"\n");
  for (int n = 0; n < 200; ++n) {
    for (const PiecesDescription& pieces : drawn_picture(plan, n).scene.pieces) {
      const CuttingPlane plane = std::get<PlaneKnife>(std::get<PlaneCut>(pieces.knives[0].cut)).plane;
      const double middle = glm::dot(plane.normal, plan.extents[0].center()) - plane.offset;
      EXPECT_LT(std::abs(middle), 0.35 * 0.5 * glm::length(plan.extents[0].size()));
    }
  }
}

TEST(DataPlan, NamesItsClasses) {
  const std::string rest = two_kinds.substr(two_kinds.find("[scene]"));
  EXPECT_THAT(plan_of(rest).classes, testing::ElementsAre("cherry", "lemon"));
  EXPECT_THAT(plan_of("classes = \"state\"\n" + rest).classes, testing::ElementsAre("whole", "half", "piece"));
  EXPECT_THAT(plan_of("classes = \"species and state\"\n" + rest).classes,
              testing::ElementsAre("cherry whole", "cherry half", "lemon piece"));
}

}  // namespace
}  // namespace pomona
