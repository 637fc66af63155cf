// pomona compare: its statuses, its files, and invalid pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include <nlohmann/json.hpp>

#include "render/image/png.h"
#include "tests/cli/run_pomona.h"

namespace pomona::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Image ramp(int width, int height, int lift = 0) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) image.pixels.emplace_back(x, y, (x + y) / 2 + lift);
  }
  return image;
}

class Compare : public ::testing::Test {
 protected:
  Compare() {
    write("a.png", write_png(ramp(90, 60)));
    write("same.png", write_png(ramp(90, 60)));
    write("lifted.png", write_png(ramp(90, 60, 1)));
    write("wide.png", write_png(ramp(91, 60)));
  }

  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
  }

  Outcome compare(std::vector<std::string> words) const {
    words.insert(words.begin(), "compare");
    return run_pomona(words, folder.path());
  }

  TemporaryFolder folder;
};

TEST_F(Compare, SaysSameWithStatusNoughtAndDifferentWithStatusOne) {
  const Outcome same = compare({"a.png", "same.png"}), lifted = compare({"a.png", "lifted.png"});
  EXPECT_EQ(same.status, 0);
  EXPECT_THAT(same.out, HasSubstr("same: mean FLIP 0.000000"));
  EXPECT_EQ(lifted.status, 1);
  EXPECT_THAT(lifted.out, HasSubstr("different: "));
  EXPECT_THAT(lifted.err, HasSubstr("5400 pixels (100.000 %) differ by more than 0"));
  EXPECT_EQ(compare({"a.png", "wide.png", "--tolerance", "close"}).status, 1);
}

TEST_F(Compare, TakesLimitsByNameAndOneByOne) {
  EXPECT_EQ(compare({"a.png", "lifted.png", "--usual", "1"}).status, 1) << "FLIP is still held to nothing";
  EXPECT_EQ(compare({"a.png", "lifted.png", "--usual", "1", "--flip", "0.1"}).status, 0);
  EXPECT_EQ(compare({"a.png", "lifted.png", "--never", "1", "--exceptions", "100", "--flip", "0.1"}).status, 0);
  EXPECT_EQ(compare({"a.png", "lifted.png", "--tolerance", "close", "--usual", "0"}).status, 1);
}

TEST_F(Compare, DoesNotWriteOverThePictures) {
  const std::string before = bytes_of(folder / "a.png");
  for (const char* option : {"--map", "--html"})
    EXPECT_EQ(compare({"a.png", "lifted.png", option, "./a.png"}).status, 64);
  EXPECT_TRUE(bytes_of(folder / "a.png") == before);
}

TEST_F(Compare, WritesTheMapAndThePageAndFiguresAsJson) {
  const Outcome outcome = compare({"a.png", "lifted.png", "--map", "map.png", "--html", "page.html", "--json"});
  EXPECT_EQ(outcome.status, 1);
  const nlohmann::json figures = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(figures["same"], false);
  EXPECT_EQ(figures["largest"], 1);
  EXPECT_EQ(figures["different"], 5400);
  EXPECT_GT(figures["flip"], 0.0);
  EXPECT_EQ(read_png(bytes_of(folder / "map.png"), "map").width, 90);
  EXPECT_THAT(bytes_of(folder / "page.html"), HasSubstr("data:image/png;base64,"));
}

TEST_F(Compare, TellsSpoiltPicturesFromMissingOnes) {
  const std::string whole = bytes_of(folder / "a.png");
  std::string flipped = whole, huge = whole;
  flipped[whole.size() / 2] = static_cast<char>(~flipped[whole.size() / 2]);
  huge.replace(16, 8, std::string("\x00\x00\x20\x00\x00\x00\x20\x00", 8));  // 8192 x 8192 in a few hundred bytes
  std::string endless = whole;
  endless.replace(16, 8, std::string("\x7f\xff\xff\xff\x7f\xff\xff\xff", 8));
  write("empty.png", "");
  write("text.png", "not a picture");
  write("cut.png", whole.substr(0, whole.size() / 2));
  write("header.png", whole.substr(0, 30));
  write("flipped.png", flipped);
  write("huge.png", huge);
  write("endless.png", endless);
  for (const char* spoilt : {"empty", "text", "cut", "header", "flipped", "huge", "endless"}) {
    const Outcome outcome = compare({"a.png", std::string(spoilt) + ".png", "--html", "page.html"});
    EXPECT_EQ(outcome.status, 65) << spoilt << ": " << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(std::string(spoilt) + ".png:byte "));
    EXPECT_FALSE(std::filesystem::exists(folder / "page.html")) << spoilt;
  }
  EXPECT_EQ(compare({"a.png", "nowhere.png"}).status, 66);
  EXPECT_EQ(compare({"a.png", "."}).status, 66);
  EXPECT_EQ(compare({"a.png"}).status, 64);
  EXPECT_EQ(compare({"a.png", "same.png", "--tolerance", "rough"}).status, 64);
  EXPECT_EQ(compare({"a.png", "same.png", "--map", "nowhere/map.png"}).status, 73);
}

TEST_F(Compare, KeepsQuietWhenAsked) {
  const Outcome outcome = compare({"a.png", "lifted.png", "--quiet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out + outcome.err, IsEmpty());
}

}  // namespace
}  // namespace pomona::testing
