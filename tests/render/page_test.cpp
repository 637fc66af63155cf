// Assets and pages of real fruit: they are read as written, and anything else is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "generator/base/error.h"
#include "generator/compose/grow.h"
#include "generator/mesh/enclosures.h"
#include "generator/piece/slice.h"
#include "generator/surface/bodies.h"
#include "generator/surface/body_walls.h"
#include "generator/template/read/read_template.h"
#include "render/export/gltf/write_glb.h"
#include "render/page/asset_file.h"
#include "render/page/byte_planes.h"
#include "render/page/cuttable_glb.h"
#include "render/page/deflate.h"
#include "render/page/make_asset.h"
#include "render/page/node_coding.h"
#include "render/page/page.h"
#include "render/page/page_scene.h"
#include "render/page/windings.h"
#include "render/style/style_file.h"

namespace pomona {
namespace {

struct Grown {
  Template fruit;
  GrownFruit grown;
};

const Grown& cherry() {
  static const Grown made = [] {
    const VariantKey key{0, 0};
    const Template fruit =
        variant_of(read_template(POMONA_SOURCE_DIR "/templates/cherry.toml"), key, {.as_drawn = true});
    return Grown{fruit, grow(fruit, key, {.as_drawn = true})};
  }();
  return made;
}

Asset draft_of(const Grown& made, int threads = 0) {
  return make_asset({made.grown, made.fruit, "cherry", 0}, {.quality = Quality::draft, .threads = {threads}});
}

const Asset& asset() {
  static const Asset made = draft_of(cherry());
  return made;
}

std::string refusal(std::string_view bytes) {
  try {
    read_asset(bytes, "x.pomona");
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    return error.what();
  }
  return "";
}

TEST(BytePlanes, GiveBackEveryNumber) {
  const std::vector<std::uint32_t> numbers = {0, 1, 65535, 0, 32768, 32767, 7, 7, 7, 65535};
  for (const std::size_t back : {1u, 2u, 100u}) EXPECT_EQ(from_planes(as_planes(numbers, back, 2), back, 2), numbers);
  const std::vector<std::uint32_t> wide = {0, 0xffffff, 0x800000, 0x7fffff, 1, 0};
  EXPECT_EQ(from_planes(as_planes(wide, 2, 3), 2, 3), wide);
}

TEST(Deflate, TellsWholeStreamsFromOthers) {
  const std::string text(100000, 'x'), packed = deflated(text);
  EXPECT_EQ(inflated(packed, text.size()), text);
  EXPECT_FALSE(inflated(packed, text.size() - 1));
  EXPECT_FALSE(inflated(packed + "x", text.size()));
  EXPECT_FALSE(inflated(std::string_view(packed).substr(0, packed.size() - 1), text.size()));
  EXPECT_FALSE(inflated("", 10));
}

TEST(Asset, IsReadAsItWasWritten) {
  const Asset& a = asset();
  const Asset b = read_asset(write_asset(a, "a test"), "x.pomona");
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.parts, b.parts);
  EXPECT_EQ(a.spared, b.spared);
  EXPECT_EQ(a.shell, b.shell);
  EXPECT_EQ(a.count, b.count);
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.spacing, b.spacing);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.front_color, b.front_color);
  EXPECT_EQ(a.back_color, b.back_color);
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.hidden, b.hidden);
  EXPECT_EQ(a.front_part, b.front_part);
  EXPECT_EQ(a.back_part, b.back_part);
  EXPECT_EQ(a.winding, b.winding);
  EXPECT_EQ(a.noise, b.noise);
  EXPECT_EQ(a.details, b.details);
  EXPECT_EQ(a.materials, b.materials);
  EXPECT_EQ(a.skin_share, b.skin_share);
  ASSERT_TRUE(a.guide && b.guide);
  EXPECT_EQ(a.guide->value, b.guide->value);
  EXPECT_EQ(a.guide->share, b.guide->share);
}

TEST(Asset, BringsTheTilesOfItsExamples) {
  Asset a = asset();
  AssetTile tile{.side = 16, .palette = {{9, 200, 30}, {255, 0, 1}, {7, 7, 7}}, .texel = {}};
  for (int i = 0; i < 4096; ++i) tile.texel.push_back(static_cast<std::uint8_t>(i * i % 3));
  a.tiles = {tile, tile};
  const Asset b = read_asset(write_asset(a, "a test"), "x.pomona");
  ASSERT_EQ(b.tiles.size(), 2u);
  EXPECT_EQ(b.tiles[1].side, 16);
  EXPECT_EQ(b.tiles[1].palette, tile.palette);
  EXPECT_EQ(b.tiles[1].texel, tile.texel);
  EXPECT_EQ(a.shell, b.shell);

  a.tiles[1].texel[77] = 3;
  EXPECT_THAT(refusal(write_asset(a, "a test")), testing::HasSubstr("a colour that is none"));
  a.tiles[1] = {.side = 64, .palette = tile.palette, .texel = std::vector<std::uint8_t>(64 * 64 * 64)};
  EXPECT_THAT(refusal(write_asset(a, "a test")), testing::HasSubstr("tile"));
  a.tiles.assign(9, tile);
  EXPECT_THAT(refusal(write_asset(a, "a test")), testing::HasSubstr("more tiles"));
}

TEST(Asset, OfAFruitByExampleHasItsTile) {
  Grown made = cherry();
  const Template kiwi = read_template(POMONA_SOURCE_DIR "/templates/kiwi.toml");
  made.fruit.details = kiwi.details;
  const Asset a = draft_of(made);
  ASSERT_EQ(a.tiles.size(), 1u);
  const ExampleTile& tile = *kiwi.details.front().tile;
  ASSERT_EQ(a.tiles[0].texel.size(), tile.texel.size());
  for (std::size_t i = 0; i < tile.texel.size(); ++i) ASSERT_EQ(a.tiles[0].palette[a.tiles[0].texel[i]], tile.texel[i]);
}

/// The largest difference between nodes before and after coding.
int worst_of_nodes(int thirds) {
  const Asset& a = asset();
  const std::vector<glm::u8vec3> read = decoded_nodes(a, coded_nodes(a, thirds), thirds).value();
  int worst = 0;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (a.winding[i] == 0) continue;
    ++inside;
    for (int k = 0; k < 3; ++k) worst = std::max(worst, std::abs(read[i][k] - a.node_color[i][k]));
  }
  EXPECT_GT(inside, 10000u);
  return worst;
}

// Knives also go around a cherry's stone when its asset is cut.
TEST(Asset, SaysWhichPartsAreSpared) {
  ASSERT_EQ(asset().spared.size(), 1u);
  EXPECT_EQ(asset().parts.at(static_cast<std::size_t>(asset().spared.front())), "stone");
}

// One shell around the stone: exactly the triangles with the stone behind them and flesh in front.
TEST(Asset, TellsTheShellAroundTheStone) {
  const Asset& a = asset();
  ASSERT_EQ(a.shell.size(), a.triangle.size());
  std::size_t around = 0;
  for (std::size_t t = 0; t < a.shell.size(); ++t) {
    const bool encloses = a.hidden[t] == 0 && a.back_part[t] == a.spared.front() && a.front_part[t] != a.spared.front();
    EXPECT_EQ(a.shell[t], encloses ? 1 : 0);
    around += encloses ? 1 : 0;
  }
  EXPECT_GT(around, 100u);
}

// Fibres of a cherry run towards its skin, on all of its sides.
TEST(Asset, GuidesDetailTowardsTheSkinAllAround) {
  const AssetGuide& guide = asset().guide.value();
  glm::ivec3 low(0), high(0);
  for (const glm::i16vec4& value : guide.value) {
    low = glm::min(low, glm::ivec3(value));
    high = glm::max(high, glm::ivec3(value));
  }
  for (const int axis : {0, 2}) {
    EXPECT_LT(low[axis], -300) << axis;
    EXPECT_GT(high[axis], 300) << axis;
  }
}

// Large differences between nodes are rounded, by at most this.
TEST(Asset, KeepsColoursOfNodesWithinOneOrTwo) {
  EXPECT_EQ(worst_of_nodes(all_thirds), 1);
  for (const int thirds : {3, thirds_of_first_format}) EXPECT_EQ(worst_of_nodes(thirds), 2);
}

// Files say how their nodes are rounded and which shells they have; those of the first format do not.
TEST(Asset, IsReadAsItIsRounded) {
  Asset a = asset();
  a.shell.clear();
  const std::string whole = write_asset(a, "a test"), magic = whole.substr(0, 8);
  std::string plain = *inflated(std::string_view(whole).substr(8), std::size_t{1} << 28);
  const std::string key = ",\"thirds\":86";
  const std::size_t format = plain.find("\"format\":2"), thirds = plain.find(key);
  ASSERT_TRUE(format < 100 && thirds < 1000);
  const std::vector<std::uint8_t> coded = coded_nodes(a), first = coded_nodes(a, thirds_of_first_format);
  ASSERT_EQ(coded.size(), first.size());

  // The same asset in the format before this choice.
  const std::size_t nodes = plain.find(std::string(coded.begin(), coded.end()));
  ASSERT_NE(nodes, std::string::npos);
  plain.replace(nodes, first.size(), std::string(first.begin(), first.end()));
  plain.replace(format, 10, "\"format\":1");
  plain.erase(thirds, key.size());
  std::uint32_t length = 0;
  for (int b = 3; b >= 0; --b) length = length << 8 | static_cast<unsigned char>(plain[static_cast<std::size_t>(b)]);
  length -= static_cast<std::uint32_t>(key.size());
  for (std::size_t b = 0; b < 4; ++b) plain[b] = static_cast<char>(length >> (8 * b) & 255);
  const Asset read = read_asset(magic + deflated(plain), "x.pomona");
  EXPECT_EQ(read.node_color, decoded_nodes(a, first, thirds_of_first_format).value());
  EXPECT_NE(read.node_color, read_asset(whole, "x.pomona").node_color);
}

// An independent test of inside and outside: the winding number of the shells around a point, by columns of solid
// angles.
TEST(Asset, WindsAroundTheNodesThatBodiesEnclose) {
  const Asset& a = asset();
  const DiffusionSurfaces& surfaces = cherry().grown.sheets;
  const Bodies bodies = find_bodies(surfaces);
  const Enclosures enclosures = body_walls(surfaces, bodies);
  std::size_t asked = 0, unlike = 0;
  for (std::size_t i = 0; i < a.winding.size(); i += 7) {
    const auto nx = static_cast<std::size_t>(a.count[0]), ny = static_cast<std::size_t>(a.count[1]);
    const glm::dvec3 place = a.origin + a.spacing * glm::dvec3(i % nx, i / nx % ny, i / (nx * ny));
    ++asked;
    if (enclosures.around(place).empty() != (a.winding[i] == 0)) ++unlike;
  }
  // Rounding moves the skin by a thousandth of a cell.
  EXPECT_LE(unlike, asked / 2000);
}

TEST(Asset, HasTheSameBytesFromAnyNumberOfThreads) {
  EXPECT_EQ(write_asset(draft_of(cherry(), 1), "a test"), write_asset(draft_of(cherry(), 3), "a test"));
}

TEST(Asset, IsRefusedWhereItIsNone) {
  const std::string whole = write_asset(asset(), "a test");
  EXPECT_THAT(refusal(""), testing::HasSubstr("no asset"));
  EXPECT_THAT(refusal("glTF" + whole), testing::HasSubstr("no asset"));
  for (const std::size_t length : {std::size_t{8}, std::size_t{9}, whole.size() / 2, whole.size() - 1})
    EXPECT_THAT(refusal(std::string_view(whole).substr(0, length)), testing::HasSubstr("cut off"));
}

// An unpacked asset may claim anything.
TEST(Asset, IsRefusedWhereItPointsOutsideItself) {
  const std::string whole = write_asset(asset(), "a test"), magic = whole.substr(0, 8);
  const std::string plain = *inflated(std::string_view(whole).substr(8), std::size_t{1} << 28);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = plain;
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return magic + deflated(bytes.replace(at, from.size(), to));
  };
  EXPECT_THAT(refusal(changed("\"format\":3", "\"format\":9")), testing::HasSubstr("format"));
  EXPECT_THAT(refusal(changed("\"thirds\":86", "\"thirds\":-6")), testing::HasSubstr("rounded"));
  EXPECT_THAT(refusal(changed("\"units\":", "\"unity\":")), testing::HasSubstr("header"));
  EXPECT_THAT(refusal(changed("\"spared\":[2]", "\"spared\":[9]")), testing::HasSubstr("spares"));
  EXPECT_THAT(refusal(changed("\"shells\":{\"count\":1", "\"shells\":{\"count\":0")), testing::HasSubstr("shells"));
  const std::string triangles = "\"triangles\":" + std::to_string(asset().triangle.size());
  EXPECT_THAT(refusal(changed(triangles, triangles.substr(0, triangles.size() - 1) + "9")), testing::Not(""));
  EXPECT_THAT(refusal(magic + deflated(plain + "x")), testing::HasSubstr("follows"));
  EXPECT_THAT(refusal(magic + deflated(std::string("\xff\xff\xff\x7f{}", 6))), testing::HasSubstr("header"));
}

// A triangle across the whole grid costs a step for every row: a small file could take hours.
TEST(Asset, IsRefusedWhereItsTrianglesAreEndless) {
  EXPECT_LT(rows_to_ask(asset()), 1'000'000) << "of a cherry";
  Asset wide = asset();
  const auto end = [&](int axis) { return static_cast<std::uint16_t>(wide.units * (wide.count[axis] - 1)); };
  wide.position[0] = {0, 0, 0}, wide.position[1] = {0, end(1), 0}, wide.position[2] = {0, 0, end(2)};
  const std::size_t many = 310'000'000 / (static_cast<std::size_t>(wide.count[1] - 1) * (wide.count[2] - 1));
  wide.triangle.assign(many, {0, 1, 2});
  wide.hidden.assign(many, 1);
  wide.front_part.assign(many, 0), wide.back_part.assign(many, 0);
  EXPECT_GT(rows_to_ask(wide), 300'000'000);
  EXPECT_THAT(refusal(write_asset(wide, "a test")), testing::HasSubstr("larger than a fruit's"));
}

TEST(Asset, IsNotMadeOfWhatIsOpen) {
  Grown open = cherry();
  DiffusionSurfaces& sheets = open.grown.sheets;
  for (std::size_t t = 0; t < sheets.triangle_count(); ++t) {
    if (!sheets.is_boundary(t)) continue;
    sheets.triangle.erase(sheets.triangle.begin() + static_cast<std::ptrdiff_t>(t));
    sheets.surface.erase(sheets.surface.begin() + static_cast<std::ptrdiff_t>(t));
    sheets.front_part.erase(sheets.front_part.begin() + static_cast<std::ptrdiff_t>(t));
    sheets.back_part.erase(sheets.back_part.begin() + static_cast<std::ptrdiff_t>(t));
    break;
  }
  EXPECT_THROW(draft_of(open), Error);
}

TEST(Page, NeedsNothingBesidesItself) {
  const std::string page =
      write_page(asset(), {.style = style_named("ink"), .cuts = {{.plane = {{0, 0, 1}, 0}}}, .made_by = "a test"});
  for (const char* reach : {"src=", "href=", "import(", "fetch(", "https:", "@import"})
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(reach))) << reach;
  EXPECT_THAT(page, testing::HasSubstr("<title>"));
  for (const char* mark : {"@TITLE@", "@ASSET@", "@SCRIPT@", "@OPTIONS@", "@WORKER@"})
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(mark)));
  EXPECT_LT(page.size(), 650'000u);
}

TEST(Page, ShowsSeedsSideBySide) {
  const std::vector<Asset> family(3, asset());
  const std::string page = write_page(family, {.style = style_named("ink"), .cuts = {}, .made_by = "a test"});
  for (const char* id : {"asset-0", "asset-1", "asset-2"}) EXPECT_THAT(page, testing::HasSubstr(id));
  EXPECT_THROW(write_page(std::span<const Asset>(), {}), Error);
  EXPECT_THROW(write_page(std::vector<Asset>(max_page_family + 1, asset()), {}), Error);
}

/// The cherry's whole solid, twice in a scene.
PageScene two_cherries() {
  const SliceTask task{
      .grown = cherry().grown, .variant = cherry().fruit, .knives = {}, .name = "cherry", .choice = {}, .origin = {}};
  PageScene page{.scene = gathered(slice(task, nullptr).pieces),
                 .name = "two",
                 .title = "Two <cherries>",
                 .fruits = {asset()},
                 .fruit_of = {},
                 .command = {}};
  page.fruit_of.assign(page.scene.solids.size(), 0);
  page.command.assign(page.scene.solids.size(), "");
  page.scene.instances.push_back(page.scene.instances.front());
  page.scene.instances.back().name = "another";
  return page;
}

TEST(ScenePage, HoldsEachFruitAndEachMeshOnce) {
  const PageScene page = two_cherries();
  const std::string text = write_scene_page(page, {.style = style_named("ink"), .cuts = {}, .made_by = "a test"});
  EXPECT_THAT(text, testing::HasSubstr("Two &lt;cherries&gt;"));
  EXPECT_THAT(text, testing::HasSubstr("id=\"asset-0\""));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr("id=\"asset-1\"")));
  PageScene more = two_cherries();
  for (int copy = 0; copy < 50; ++copy) more.scene.instances.push_back({0, {}, "copy-" + std::to_string(copy)});
  EXPECT_LT(packed_scene(more).size(), packed_scene(page).size() + 3000);
}

TEST(ScenePage, TellsWhatItDoesNotTake) {
  PageScene page = two_cherries();
  EXPECT_NO_THROW(check_fits_a_page(page.scene, 1));
  EXPECT_THROW(check_fits_a_page(page.scene, max_page_fruits + 1), Error);
  page.scene.instances.resize(max_page_instances + 1, page.scene.instances.front());
  EXPECT_THROW(write_scene_page(page, {}), Error);
}

TEST(CuttableGlb, IsTheSameGlbWithTheAssetBehindIt) {
  const std::string glb = write_glb(two_cherries().scene), bytes = write_asset(asset(), "a test");
  const std::string cuttable = with_asset(glb, bytes);
  EXPECT_THAT(cuttable, testing::HasSubstr("\"extensionsUsed\""));
  EXPECT_THAT(cuttable, testing::HasSubstr("\"POMONA_cuttable\":{\"bufferView\":"));
  EXPECT_THAT(cuttable, testing::Not(testing::HasSubstr("extensionsRequired")));
  const std::size_t at = cuttable.find(bytes);
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(at % 4, 0u);
  EXPECT_EQ(cuttable.size() % 4, 0u);
  for (const std::string& none : {std::string(), glb.substr(0, 30), glb.substr(0, glb.size() - 40), "x" + glb})
    EXPECT_THROW(with_asset(none, bytes), Error);
}

}  // namespace
}  // namespace pomona
