#include "generator/data/data_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pomona {
namespace {

using ::testing::HasSubstr;

const std::string head = "[data]\nformat = 1\nname = \"d\"\ncount = 3\n";
const std::string fruit = "[[fruit]]\nname = \"f\"\ntemplates = \"kiwi\"\n";

/// The first message about a file, with its place.
std::string told(const std::string& toml) {
  try {
    parse_data(toml, "d.toml");
  } catch (const Error& error) {
    return to_string(error.diagnostics().front());
  }
  return "nothing is told";
}

TEST(DataFile, ReadsItsLaws) {
  const DataDescription data = parse_data(
      head + "size = [320, 200]\nstyle = [\"ink\", \"photo\"]\nsplit = [6, 2, 2]\n" +
          "[view]\nazimuth = [-90, 90]\nfield = 30\n[camera]\nnoise = [0, 0.1]\n" + fruit +
          "knives = [[], \"half\", [\"half\", \"across\"], \"random:2\"]\npieces = [1, 4]\nripeness = [0.5, 1.5]\n",
      "d.toml");
  EXPECT_EQ(data.width, 320);
  EXPECT_EQ(data.styles.size(), 2u);
  EXPECT_DOUBLE_EQ(data.split[0], 0.6);
  EXPECT_DOUBLE_EQ(data.view.azimuth.low, -data.view.azimuth.high);
  EXPECT_DOUBLE_EQ(data.view.field.low, data.view.field.high);
  EXPECT_DOUBLE_EQ(data.camera.noise.high, 0.1);
  const DataFruit& kind = data.kinds.front();
  ASSERT_EQ(kind.cuts.size(), 4u);
  EXPECT_TRUE(kind.cuts[0].empty());
  EXPECT_EQ(kind.cuts[2].size(), 2u);
  EXPECT_EQ(kind.cuts[3].front().random_planes, 2);
  EXPECT_EQ(kind.pieces.high, 4);
}

TEST(DataFile, TellsMistakesWithTheirPlaces) {
  EXPECT_THAT(told(head), HasSubstr("fruit"));
  EXPECT_THAT(told(head + "cuont = 3\n" + fruit), HasSubstr("d.toml:5:1: error: unknown key \"cuont\""));
  EXPECT_THAT(told(head + "cuont = 3\n" + fruit), HasSubstr("did you mean \"count\"?"));
  EXPECT_THAT(told(head + fruit + "knives = \"hlaf\"\n"), HasSubstr("d.toml:8:10: error"));
  EXPECT_THAT(told(head + fruit + "knives = \"random:99\"\n"), HasSubstr("d.toml:8:10: error"));
  EXPECT_THAT(told(head + fruit + "pieces = [3, 1]\n"), HasSubstr("is empty"));
  EXPECT_THAT(told(head + fruit + "pieces = [1, 2, 3]\n"), HasSubstr("needs two values"));
  EXPECT_THAT(told(head + fruit + "ripeness = 3\n"), HasSubstr("d.toml:8:12: error"));
  EXPECT_THAT(told(head + "[view]\nelevation = 95\n" + fruit), HasSubstr("d.toml:6:13: error"));
  EXPECT_THAT(told(head + "[view]\nfit = 1\ndistance = \"1m\"\n" + fruit), HasSubstr("exclude each other"));
  EXPECT_THAT(told(head + "[view]\ndistance = 1\n" + fruit), HasSubstr("d.toml:6:12: error"));
  EXPECT_THAT(told(head + "[scene]\ndistractors = 1\n" + fruit), HasSubstr("use = \"beside\""));
  EXPECT_THAT(told(head + "[scene]\ndish = 0.5\n" + fruit), HasSubstr("use = \"in\""));
  EXPECT_THAT(told(head + "[ground]\npicture = \"nowhere\"\n" + fruit), HasSubstr("names no picture"));
  EXPECT_THAT(told(head + "[ground]\nshare = 0.5\n" + fruit), HasSubstr("not named"));
  EXPECT_THAT(told(head + "[ground]\ntransparent = true\n[camera]\nblur = 1\n" + fruit), HasSubstr("transparent"));
  EXPECT_THAT(told(head + "split = [0, 0, 0]\n" + fruit), HasSubstr("no share above 0"));
  EXPECT_THAT(told(head + fruit + fruit), HasSubstr("d.toml:9:8: error"));
}

TEST(DataFile, LawsLeaveOutWhatChangesNoPicture) {
  const std::string laws = parse_data(head + fruit, "d.toml").laws;
  EXPECT_EQ(
      parse_data("[data]\nformat = 1\nname = \"d\"\ncount = 9\nsplit = [1, 1, 1]\ntitle = \"D\"\n" + fruit, "d.toml")
          .laws,
      laws);
  EXPECT_NE(parse_data(head + "detail = 0.4\n" + fruit, "d.toml").laws, laws);
}

}  // namespace
}  // namespace pomona
