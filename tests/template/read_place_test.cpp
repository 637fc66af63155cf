// [[place]]: what it reads, and what it refuses.
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/base/units.h"
#include "generator/template/read/read_template.h"
#include "tests/base/temporary_folder.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

const std::string head = R"(
format = 1
unit = "1mm"
parts = ["skin", "flesh"]
density = 900
[symmetry]
kind = "cylindrical"
[[surface]]
name = "skin"
type = "around-axis"
vertical = "M 0 0 L 5 -5 L 0 -10"
front = { part = "skin", hidden = true, color = "#ffffff" }
back = { part = "flesh", color = "#ffffff" }
[law.seats]
kind = "spiral"
spacing = "4mm"
)";

std::string place_of(const std::string& file, const std::string& more = "") {
  return "[[place]]\nname = \"berry\"\nlaw = \"seats\"\nsurface = \"skin\"\ntemplate = \"" + file + "\"\n" + more;
}

class ReadPlace : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& more) {
    const std::filesystem::path file = folder_.path() / (name + ".toml");
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << "name = \"" << file.stem().string() << "\"\n" << head << more;
  }

  Template read(const std::string& name) const { return read_template(folder_.path() / (name + ".toml")); }

  std::string fault(const std::string& name) const {
    try {
      read(name);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  }

  TemporaryFolder folder_;
};

TEST_F(ReadPlace, all_keys) {
  write("in/small", "[material.flesh]\nwet = 3\n[noise]\nbase_frequency = 9\n");
  write("large", place_of("in/small.toml", R"(seat = "top"
heading = "up"
tilt = 10
turn_jitter = 90
sink = "1mm"
size = [[0.0, 1.0], [1.0, 0.5]]
size_jitter = 0.1
individuals = 5
detail = 0.5
press = { surface = "skin", heart = 0.4, gap = "0.3mm", soft = 0.05, root = "0.5mm", against = ["skin"] }
stalk = { from = "skin", rise = "3mm", width = ["2mm", "1mm"], part = "flesh", color = "#00ff00" }
merge = { skin = "flesh" }
)"));
  const Template fruit = read("large");
  ASSERT_EQ(fruit.places.size(), 1u);
  const PlaceSketch& place = fruit.places[0];
  EXPECT_EQ(place.placed->name, "small");
  EXPECT_EQ(place.foot, PlaceSketch::Foot::top);
  EXPECT_EQ(place.heading, PlaceSketch::Heading::up);
  EXPECT_NEAR(place.tilt, radians(10), 1e-12);
  EXPECT_NEAR(place.size(0.5), 0.75, 1e-6);
  EXPECT_EQ(place.individuals, 5);
  ASSERT_TRUE(place.press && place.press->root && place.stalk);
  EXPECT_EQ(*place.press->root, 0.0005);
  EXPECT_THAT(place.press->against, testing::ElementsAre(0));
  EXPECT_EQ(place.stalk->top_width, 0.001);
  EXPECT_THAT(fruit.parts, testing::ElementsAre("skin", "flesh", "berry.flesh"));
  EXPECT_THAT(place.parts, testing::ElementsAre(1, 2));
  EXPECT_EQ(fruit.materials.at(2).wet, 3);
  EXPECT_EQ(fruit.noise.base_frequency, 9);
}

TEST_F(ReadPlace, four_deep_and_no_more) {
  write("a4", "");
  for (int level = 3; level >= 0; --level)
    write("a" + std::to_string(level), place_of("a" + std::to_string(level + 1) + ".toml"));
  EXPECT_EQ(fault("a0"), "");
  write("a4", place_of("a5.toml"));
  write("a5", "");
  EXPECT_THAT(fault("a0"), testing::HasSubstr("more than 4 templates deep"));
}

TEST_F(ReadPlace, never_itself) {
  write("self", place_of("self.toml"));
  EXPECT_THAT(fault("self"), testing::HasSubstr("places a template within itself"));
  write("first", place_of("second.toml"));
  write("second", place_of("../" + folder_.path().filename().string() + "/first.toml"));
  EXPECT_THAT(fault("first"), testing::HasSubstr("places a template within itself"));
}

TEST_F(ReadPlace, mistakes_in_what_is_placed_are_told_there) {
  write("bad", "colour = 3\n");
  write("good", place_of("bad.toml"));
  EXPECT_THAT(fault("good"), testing::HasSubstr("bad.toml"));
}

TEST_F(ReadPlace, materials_of_what_is_placed_are_told_where_they_belong) {
  write("in/small", "");
  for (const std::string key : {"berry.flesh", "\"berry.flesh\""}) {
    write("large", place_of("in/small.toml") + "[material." + key + "]\nwet = 2\n");
    EXPECT_THAT(fault("large"), testing::HasSubstr("write it as [material.PART] into in/small.toml")) << key;
    EXPECT_THAT(fault("large"), testing::Not(testing::HasSubstr("unknown key"))) << key;
  }
  write("large", place_of("in/small.toml") + "[material.flesh]\nwet = 2\n");
  EXPECT_EQ(fault("large"), "");
}

TEST_F(ReadPlace, what_is_missing_is_told_alone) {
  write("bunch", place_of("none.toml", "press = { surface = \"skin\" }\nmerge = { skin = \"skin\" }\n"));
  EXPECT_THAT(fault("bunch"), testing::HasSubstr("cannot be read"));
  EXPECT_THAT(fault("bunch"), testing::Not(testing::HasSubstr("unknown key")));
}

TEST_F(ReadPlace, near_names_are_suggested) {
  write("grape", "");
  write("file", place_of("grap.toml"));
  EXPECT_THAT(fault("file"), testing::HasSubstr("did you mean grape.toml?"));
  write("part", place_of("grape.toml", "merge = { skni = \"skin\" }\n"));
  EXPECT_THAT(fault("part"), testing::HasSubstr("did you mean \"skin\"?"));
}

TEST(ReadPlaceMistakes, are_found) {
  constexpr std::array mistakes{
      Mistake{
          "[law.b]\nkind = \"spiral\"\nspacing = \"2mm\"\n[[place]]\nname = \"a\"\nlaw = \"b\"\nsurface = \"skin\"\n",
          4, 1, "lacks \"template\""},
      Mistake{"[law.b]\nkind = \"spiral\"\nspacing = \"2mm\"\n[[place]]\nname = \"a\"\nlaw = \"b\"\nsurface = "
              "\"skin\"\ntemplate = \"a.png\"\n",
              8, 12, "is no template"},
      Mistake{"[law.b]\nkind = \"spiral\"\nspacing = \"2mm\"\n[[place]]\nname = \"a\"\nlaw = \"b\"\nsurface = "
              "\"skin\"\ntemplate = \"../a.toml\"\n",
              8, 12, "leads out of the template's folder"},
      Mistake{"[law.b]\nkind = \"spiral\"\nspacing = \"2mm\"\n[[place]]\nname = \"a\"\nlaw = \"b\"\nsurface = "
              "\"skin\"\ntemplate = \"none.toml\"\n",
              8, 12, "cannot be read"},
      Mistake{"[law.b]\nkind = \"cluster\"\nspacing = \"2mm\"\n", 1, 1, "lacks \"envelope\""},
      Mistake{"[law.b]\nkind = \"cluster\"\nspacing = \"2mm\"\nenvelope = \"M 3 0 L -1 -4\"\n", 4, 12,
              "left of the axis"},
      Mistake{"[law.b]\nkind = \"cluster\"\nspacing = \"2mm\"\nenvelope = \"M 3 0 L 4 -4 L 5 -3\"\n", 4, 12,
              "turns back down"},
  };
  expect_found(mistakes);
}

}  // namespace
}  // namespace pomona
