// [[detail]]: good.toml with more at its end.
#include "generator/template/read/read_detail.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/template/read/read_template.h"

namespace pomona {
namespace {

std::string good_fruit() {
  std::ifstream stream(std::filesystem::path(POMONA_SOURCE_DIR) / "tests/template/good.toml", std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<DetailSketch> details_of(const std::string& more) {
  return parse_template(good_fruit() + more, "plum.toml").details;
}

/// A detail with only the required keys, and more keys.
std::string rays_with(const std::string& more) {
  return "\n[[detail]]\nkind = \"fibres\"\npart = \"flesh\"\nsize = \"1mm\"\namount = 0.5\n" + more + "\n";
}

std::string complaint_about(const std::string& more) {
  try {
    details_of(more);
  } catch (const Error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ReadDetail, says_nothing_where_nothing_is_said) { EXPECT_TRUE(details_of("").empty()); }

TEST(ReadDetail, reads_all_there_is) {
  const std::vector<DetailSketch> details = details_of(R"(
[[detail]]
kind = "speckles"
on = "cut"
part = ["flesh", "skin"]
run = "to_skin"
size = ["0.5mm", "1mm"]
length = "2cm"
width = 0.2
density = 0.1
softness = 0.3
wander = 1.5
variety = 0.9
amount = 0.7
color = "#ffffff"
near = "#000000"
near_within = 0.3
depth = [["0mm", 0.0], ["10mm", 1.0]]
relief = "-0.3mm"

[[detail]]
kind = "net"
part = "skin"
size = "5mm"
amount = -0.2
axis = [0, 1, 0]
)");
  ASSERT_EQ(details.size(), 2u);
  EXPECT_EQ(details[0].kind, DetailKind::speckles);
  EXPECT_EQ(details[0].face, DetailFace::cut);
  EXPECT_EQ(details[0].run, DetailRun::to_skin);
  EXPECT_EQ(details[0].parts.size(), 2u);
  EXPECT_NEAR(details[0].smallest, 5e-4, 1e-12);
  EXPECT_NEAR(details[0].size, 1e-3, 1e-12);
  EXPECT_NEAR(details[0].length, 2e-2, 1e-12);
  EXPECT_EQ(details[0].wander, 1.5);
  EXPECT_EQ(details[0].color, Color(1.0f));
  EXPECT_EQ(details[0].near, Color(0.0f));
  EXPECT_NEAR(details[0].depth(0.005), 0.5, 1e-6);
  EXPECT_GT(details[0].reach, 0.0);
  EXPECT_GT(details[0].middle, 0.0);
  EXPECT_NEAR(details[0].relief, -3e-4, 1e-12);
  EXPECT_EQ(details[1].relief, 0.0);
  EXPECT_EQ(details[1].face, DetailFace::skin);
  EXPECT_EQ(details[1].run, DetailRun::none);
  EXPECT_EQ(details[1].length, details[1].size);
  EXPECT_EQ(details[1].amount, -0.2);
  EXPECT_EQ(details[1].axis, glm::vec3(0, 1, 0));
  EXPECT_FALSE(details[1].color || details[1].near);
}

TEST(ReadDetail, tells_what_is_wrong) {
  using testing::HasSubstr;
  EXPECT_EQ(complaint_about(rays_with("")), "nothing");
  EXPECT_THAT(complaint_about("\n[[detail]]\n"), HasSubstr("kind"));
  EXPECT_THAT(complaint_about(rays_with("length = \"2mm\"")), HasSubstr("along a run"));
  EXPECT_THAT(complaint_about(rays_with("color = \"#ffffff\"\naxis = [1, 0, 0]")), HasSubstr("beside a color"));
  EXPECT_THAT(complaint_about(rays_with("axis = [0, 0, 0]")), HasSubstr("no direction"));
  EXPECT_THAT(complaint_about(rays_with("axis = [0, 1]")), HasSubstr("three numbers"));
  EXPECT_THAT(complaint_about(rays_with("density = 1.0")), HasSubstr("density"));
  EXPECT_THAT(complaint_about(rays_with("wander = nan")), HasSubstr("wander"));
  EXPECT_THAT(complaint_about(rays_with("near = \"red\"")), HasSubstr("near"));
  EXPECT_THAT(complaint_about(rays_with("run = \"sideways\"")), HasSubstr("run"));
  EXPECT_THAT(complaint_about(rays_with("kinds = 1")), HasSubstr("kinds"));
  const std::string dots = "\n[[detail]]\nkind = \"speckles\"\namount = 0.5\npart = ";
  EXPECT_THAT(complaint_about(dots + "\"peel\"\nsize = \"1mm\"\n"), HasSubstr("peel"));
  EXPECT_THAT(complaint_about(dots + "[]\nsize = \"1mm\"\n"), HasSubstr("names no part"));
  EXPECT_THAT(complaint_about(dots + "\"skin\"\nsize = \"0mm\"\n"), HasSubstr("size"));
  EXPECT_THAT(complaint_about(dots + "\"skin\"\nsize = [\"2mm\", \"1mm\"]\n"), HasSubstr("least first"));
  EXPECT_THAT(complaint_about(dots + "\"skin\"\nsize = [\"2mm\"]\n"), HasSubstr("two lengths"));
}

TEST(ReadDetail, takes_four_of_each_face) {
  std::string four, dots;
  for (int i = 0; i < 4; ++i) four += rays_with(""), dots += rays_with("on = \"skin\"");
  EXPECT_EQ(details_of(four + dots).size(), 8u);
  EXPECT_THAT(complaint_about(four + rays_with("")), testing::HasSubstr("one too many"));
  EXPECT_NE(complaint_about(four + dots + rays_with("")), "nothing");
}

}  // namespace
}  // namespace pomona
