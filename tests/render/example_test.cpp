// Texture by example: its file, what a tile shows, and what it does to colours.
#include "render/style/example.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/template/read/read_template.h"
#include "render/image/png.h"
#include "render/style/look.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

const RandomStream stream({5, 0}, "example_test");

/// Two kinds of flesh, unevenly mixed, of 224 colours.
std::vector<glm::u8vec3> some_texels(int side) {
  std::vector<glm::u8vec3> texel;
  for (int i = 0; i < side * side * side; ++i) {
    const double chance = std::floor(32 * stream.uniform(static_cast<std::uint64_t>(i))) / 31;
    texel.emplace_back(255 * chance, chance > 0.8 ? 250 : 90 * chance, i % 7);
  }
  return texel;
}

ExampleTile some_tile(int side) { return example_tile("flesh.png", side, some_texels(side)); }

// ---- The file ----

std::string good_fruit() {
  std::ifstream file(fs::path(POMONA_SOURCE_DIR) / "tests/template/good.toml", std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string example_with(const std::string& more) {
  return "\n[[detail]]\nkind = \"example\"\npart = \"flesh\"\nsize = \"8mm\"\namount = 0.5\n" + more + "\n";
}

/// A folder for a template and its pictures.
class ExampleFile : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const {
    fs::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name, std::ios::binary) << bytes;
  }
  void write_cube(const std::string& name, int width, int height) const {
    write(name, write_png(Image{width, height, std::vector<glm::u8vec3>(static_cast<std::size_t>(width) * height)}));
  }
  std::vector<DetailSketch> read(const std::string& more) const {
    return parse_template(good_fruit() + more, (folder_.path() / "plum.toml").string()).details;
  }
  std::string complaint_about(const std::string& more) const {
    try {
      read(more);
    } catch (const Error& error) {
      return error.what();
    }
    return "nothing";
  }

  TemporaryFolder folder_;
};

TEST_F(ExampleFile, IsSlicesOneBelowTheOther) {
  const std::vector<glm::u8vec3> texels = some_texels(16);
  write("textures/flesh.png", write_png(Image{16, 256, texels}));
  const std::string one = example_with("example = \"textures/flesh.png\"\nrun = \"to_skin\"\nlength = \"10cm\"");
  const std::vector<DetailSketch> details = read(one + one);
  ASSERT_EQ(details.size(), 2u);
  ASSERT_NE(details[0].tile, nullptr);
  EXPECT_EQ(details[0].tile->texel, texels);
  EXPECT_EQ(details[0].tile->side(), 16);
  EXPECT_EQ(details[0].tile->levels[0].color[37], from_srgb8(texels[37]));
  EXPECT_EQ(details[0].face, DetailFace::cut);
  EXPECT_NEAR(details[0].size, 8e-3, 1e-12);
  EXPECT_NEAR(details[0].length, 0.1, 1e-12);
  EXPECT_EQ(details[0].tile, details[1].tile);
}

TEST_F(ExampleFile, TellsWhatIsWrongWithThePicture) {
  using testing::AllOf, testing::HasSubstr;
  write_cube("good.png", 16, 256);
  const std::string good = write_png(Image{16, 256, some_texels(16)});
  write("text.png", "no picture");
  write("cut.png", good.substr(0, good.size() / 2));
  std::vector<glm::u8vec3> many;
  for (int i = 0; i < 4096; ++i) many.emplace_back(i & 255, i >> 8, 0);
  write("many.png", write_png(Image{16, 256, many}));
  write_cube("20.png", 20, 400), write_cube("short.png", 16, 255), write_cube("large.png", 64, 4096);
  write("long.png", good + std::string(std::size_t{1} << 20, 'x'));
  const auto complaint = [&](const std::string& file) {
    return complaint_about(example_with("example = \"" + file + "\""));
  };
  EXPECT_EQ(complaint("good.png"), "nothing");
  EXPECT_THAT(complaint("gone.png"), AllOf(HasSubstr("plum.toml:"), HasSubstr("there is no such file")));
  EXPECT_THAT(complaint("../good.png"), HasSubstr("leads out of the template's folder"));
  EXPECT_THAT(complaint((folder_.path() / "good.png").string()), HasSubstr("leads out of the template's folder"));
  EXPECT_THAT(complaint("text.png"), AllOf(HasSubstr("plum.toml:"), HasSubstr("not a readable PNG")));
  EXPECT_THAT(complaint("cut.png"), HasSubstr("it ends too early"));
  EXPECT_THAT(complaint("20.png"), HasSubstr("20 x 400 pixels"));
  EXPECT_THAT(complaint("short.png"), HasSubstr("16 x 255 pixels"));
  EXPECT_THAT(complaint("large.png"), HasSubstr("not a readable PNG"));
  EXPECT_THAT(complaint("many.png"), HasSubstr("more than 256 colours"));
  EXPECT_THAT(complaint("long.png"), HasSubstr("MiB"));
  EXPECT_THAT(complaint("."), HasSubstr("is a folder"));
  EXPECT_THAT(complaint(""), HasSubstr("is a folder"));
}

TEST_F(ExampleFile, TellsWhichKeysAnExampleHasNoUseFor) {
  using testing::HasSubstr;
  write_cube("good.png", 16, 256);
  const std::string file = "example = \"good.png\"\n";
  for (const char* key : {"width", "density", "softness", "wander", "variety"})
    EXPECT_THAT(complaint_about(example_with(file + key + " = 0.5")), HasSubstr("an example shows its own")) << key;
  EXPECT_THAT(complaint_about(example_with(file + "color = \"#ffffff\"")), HasSubstr("an example shows its own"));
  EXPECT_THAT(complaint_about(example_with("")), HasSubstr("example"));
  EXPECT_THAT(
      complaint_about("\n[[detail]]\nkind = \"cells\"\npart = \"flesh\"\nsize = \"1mm\"\namount = 0.5\n" + file),
      HasSubstr("the kind is another"));
  EXPECT_THAT(
      complaint_about("\n[[detail]]\nkind = \"example\"\npart = \"flesh\"\nsize = [\"1mm\", \"2mm\"]\namount = 0.5\n" +
                      file),
      HasSubstr("one length"));
  EXPECT_THAT(
      complaint_about("\n[[detail]]\nkind = \"example\"\npart = \"flesh\"\nsize = \"1mm\"\namount = -0.5\n" + file),
      HasSubstr("amount"));
}

// ---- The tile ----

/// Places on a lattice of half texels: the mean of what is interpolated there is that of the texels.
void for_all_places(int side, const std::function<void(const glm::dvec3&)>& visit) {
  for (int z = 0; z < 2 * side; ++z)
    for (int y = 0; y < 2 * side; ++y)
      for (int x = 0; x < 2 * side; ++x) visit((glm::dvec3(x, y, z) + 0.25) / (2.0 * side));
}

TEST(Example, repeats_itself_in_whole_tiles) {
  const ExampleTile tile = some_tile(16);
  for (std::uint64_t i = 0; i < 500; ++i) {
    const glm::dvec3 place = glm::dvec3(glm::u8vec3(256.0 * stream.uniform(3 * i), 256.0 * stream.uniform(3 * i + 1),
                                                    256.0 * stream.uniform(3 * i + 2))) /
                             256.0;
    for (const double texels : {0.0, 1.5, 5.0})
      EXPECT_EQ(tile_color(tile, place, texels), tile_color(tile, place + glm::dvec3(1, -2, 3), texels));
  }
}

TEST(Example, shows_its_texels_and_is_continuous_between_them) {
  const ExampleTile tile = some_tile(16);
  for (int i = 0; i < 4096; ++i) {
    const glm::dvec3 middle = (glm::dvec3(i % 16, i / 16 % 16, i / 256) + 0.5) / 16.0;
    EXPECT_EQ(tile_color(tile, middle, 0), from_srgb8(tile.texel[static_cast<std::size_t>(i)]));
    const glm::dvec3 beside(1e-9, -1e-9, 1e-9);
    EXPECT_LT(glm::distance(tile_color(tile, middle + beside, 0), tile_color(tile, middle, 0)), 1e-6f);
    const glm::dvec3 seam(0, 0.3, 0.7);
    EXPECT_LT(glm::distance(tile_color(tile, seam - 1e-9, 0), tile_color(tile, seam + 1e-9, 0)), 1e-6f);
  }
}

TEST(Example, has_one_mean_at_every_distance_and_goes_over_into_it) {
  for (const int side : {16, 48}) {
    const ExampleTile tile = some_tile(side);
    double last = 1e9;
    for (const double texels : {0.0, 1.0, 1.5, 2.0, 3.0, 4.0, 7.0, 16.0, 64.0}) {
      glm::dvec3 sum(0), squares(0);
      for_all_places(16, [&](const glm::dvec3& place) {
        const glm::dvec3 color(tile_color(tile, place, texels));
        sum += color / 32768.0, squares += color * color / 32768.0;
      });
      if (side == 16) {
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], tile.mean()[k], 1e-6) << texels;
      }
      const double variance = squares.x - sum.x * sum.x;
      EXPECT_LE(variance, last + 1e-12) << texels;
      last = variance;
    }
    EXPECT_LT(last, 1e-9);
  }
}

TEST(Example, keeps_the_mean_of_every_color_in_linear_light) {
  const ExampleTile tile = some_tile(16);
  for (const Color& color : {Color(0.2f, 0.5f, 0.05f), Color(0.98f, 0.01f, 1.0f), Color(0.0f, 0.9f, 0.4f)}) {
    for (const double weight : {0.3, 1.0}) {
      glm::dvec3 sum(0);
      for_all_places(16, [&](const glm::dvec3& place) {
        sum += glm::dvec3(with_example(color, tile, tile_color(tile, place, 0), weight)) / 32768.0;
      });
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[k], color[k], 1e-6) << weight;
    }
  }
}

TEST(Example, clips_nothing) {
  const ExampleTile tile = some_tile(16);
  int at_an_end = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const Color color(stream.uniform(3 * i), stream.uniform(3 * i + 1), i % 5 == 0 ? 0.0 : i % 5 == 1 ? 1.0 : 0.02);
    const glm::dvec3 place(stream.uniform(3 * i + 2), stream.uniform(3 * i), stream.uniform(3 * i + 1));
    const Color changed = with_example(color, tile, tile_color(tile, place, 0), 1);
    for (int k = 0; k < 3; ++k) {
      ASSERT_GE(changed[k], 0.0f);
      ASSERT_LE(changed[k], 1.0f);
      at_an_end += color[k] > 0.0f && color[k] < 1.0f && (changed[k] == 0.0f || changed[k] == 1.0f) ? 1 : 0;
    }
  }
  EXPECT_LT(at_an_end, 20);
}

// ---- Within a look ----

DetailSketch some_example() {
  DetailSketch detail;
  detail.kind = DetailKind::example;
  detail.run = DetailRun::to_skin;
  detail.size = 8e-3, detail.length = 0.1;
  detail.amount = 0.8;
  detail.parts = {0};
  detail.tile = std::make_shared<const ExampleTile>(some_tile(16));
  return detail;
}

LookPlace some_place(std::uint64_t i, double footprint = 0) {
  const glm::vec3 p(0.04 * stream.uniform(3 * i), 0.04 * stream.uniform(3 * i + 1), 0.04 * stream.uniform(3 * i + 2));
  return {.position = glm::dvec3(p), .footprint = footprint, .guide = {0.2f * p, 0.01f, glm::vec4(1)}};
}

TEST(Example, depends_on_the_place_and_the_variant_alone) {
  DetailSketch detail = some_example();
  const Look drawn(NoiseStyle{}, {detail}), again(NoiseStyle{}, {detail}, &drawn);
  detail.pattern = 77;
  const Look variant(NoiseStyle{}, {detail}, &drawn);
  const Color plain(0.4f, 0.3f, 0.1f);
  double apart = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(drawn(plain, some_place(i)), again(plain, some_place(i)));
    apart += glm::distance(drawn(plain, some_place(i)), variant(plain, some_place(i))) / 1000;
  }
  EXPECT_GT(apart, 0.05);
}

TEST(Example, leaves_every_bit_where_it_has_no_share_and_the_color_from_afar) {
  const Look look(NoiseStyle{}, {some_example()});
  const Color plain(0.4f, 0.3f, 0.1f);
  for (std::uint64_t i = 0; i < 100; ++i) {
    LookPlace place = some_place(i);
    EXPECT_LT(glm::distance(look(plain, some_place(i, 0.05)), plain), 1e-6f);
    EXPECT_NE(look(plain, place), plain);
    place.guide.share = glm::vec4(0);
    EXPECT_EQ(look(plain, place), plain);
  }
}

TEST(Example, comes_before_the_other_details_and_near_its_color_alone) {
  // A detail that goes all the way to its colour hides what examples have done, whatever the order in the file.
  DetailSketch cover;
  cover.kind = DetailKind::speckles;
  cover.amount = 1, cover.density = 0.99, cover.softness = 0, cover.color = Color(0.2f, 0.2f, 0.2f);
  cover.size = cover.smallest = cover.length = 1e-3;
  const Look first(NoiseStyle{}, {some_example(), cover}), last(NoiseStyle{}, {cover, some_example()});
  int covered = 0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    for (const Look* look : {&first, &last})
      covered += glm::distance((*look)(Color(0.4f, 0.3f, 0.1f), some_place(i)), *cover.color) < 1e-3f ? 1 : 0;
  }
  EXPECT_GT(covered, 100);

  DetailSketch near = some_example();
  near.near = Color(0.6f, 0.02f, 0.02f), near.near_within = 0.05;
  const Look of_red(NoiseStyle{}, {near});
  for (std::uint64_t i = 0; i < 100; ++i) {
    EXPECT_LT(glm::distance(of_red(Color(0.05f, 0.4f, 0.05f), some_place(i)), Color(0.05f, 0.4f, 0.05f)), 0.01f);
    EXPECT_NE(of_red(*near.near, some_place(i)), *near.near);
  }
}

}  // namespace
}  // namespace pomona
