// USD as text; tests/programs/usd_test.mjs has another program read it.
#include "render/export/usd/write_usda.h"

#include <gmock/gmock.h>

#include "render/export/usd/usda_text.h"
#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

using testing::HasSubstr;

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(Usda, TellsEachMeshOnceAndRefersToItAsOftenAsAsked) {
  const std::string text = write_usda(named::mixed());
  EXPECT_EQ(occurrences(text, "def Mesh "), 3u) << "the empty solid is no mesh";
  EXPECT_EQ(occurrences(text, "references = </Pieces/box>"), 2u);
  EXPECT_THAT(text, testing::StartsWith("#usda 1.0\n"));
  for (const char* word : {"defaultPrim = \"Scene\"", "metersPerUnit = 1\n", "upAxis = \"Y\"", "def Camera \"view\""})
    EXPECT_THAT(text, HasSubstr(word));
}

TEST(Usda, BracesAndBracketsArePaired) {
  Scene scene = named::with_materials();
  scene.solids[0].origin = {.source = "a \"b\"\\\n{", .knives = {"half"}, .number = 1, .pieces = 2, .fruit = "kiwi"};
  std::vector<std::vector<Solid>> levels{{scene.solids[0]}};
  levels.resize(scene.solids.size());
  for (const bool together : {false, true}) {
    const std::string text = write_usda(scene, {.instances = together}, levels);
    std::string open;
    bool in_words = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\\' && in_words) {
        ++i;
      } else if (text[i] == '"') {
        in_words = !in_words;
      } else if (!in_words && std::string("([{").find(text[i]) != std::string::npos) {
        open += text[i];
      } else if (!in_words && std::string(")]}").find(text[i]) != std::string::npos) {
        ASSERT_FALSE(open.empty());
        EXPECT_LE(text[i] - open.back(), 2) << "another kind of bracket";
        open.pop_back();
      }
      ASSERT_FALSE(in_words && text[i] == '\n') << "words end in their line";
    }
    EXPECT_TRUE(open.empty());
    EXPECT_THAT(text, HasSubstr("variantSet \"LOD\" = {"));
  }
}

TEST(Usda, NamesAreOnesThatUsdTakes) {
  usd::PrimNames names;
  EXPECT_EQ(names.name_for("tomato-wedges-1.piece-2"), "tomato_wedges_1_piece_2");
  EXPECT_EQ(names.name_for("tomato_wedges-1.piece_2"), "tomato_wedges_1_piece_2_2");
  EXPECT_EQ(names.name_for("3"), "_3");
  EXPECT_EQ(names.name_for("ü"), "__");
  EXPECT_EQ(names.name_for(""), "_");
}

TEST(Usda, NumbersAreShortAndExactToTheirStep) {
  std::string text;
  for (const double number : {0.1234567891, -0.00000004, 12.0, -0.5}) {
    usd::append_number(text, number, 1e-7);
    text += ' ';
  }
  EXPECT_EQ(text, "0.1234568 0 12 -0.5 ");
  EXPECT_EQ(usd::quoted("a\"b\\c\nd"), "\"a\\\"b\\\\c d\"");
}

TEST(Usda, InstancesMayBePoints) {
  const Scene scene = named::mixed();
  const std::string text = write_usda(scene, {.instances = true});
  EXPECT_EQ(occurrences(text, "def PointInstancer"), 1u);
  EXPECT_THAT(text, HasSubstr("protoIndices = [0, 0, 1, 2]"));
  EXPECT_EQ(occurrences(text, "xformOp:orient"), 2u) << "the camera's alone, and its order";
}

TEST(Usda, SaysMassAndLabels) {
  Scene scene = named::with_materials();
  scene.solids[0].origin = {.source = "kiwi", .knives = {"half"}, .number = 2, .pieces = 2, .fruit = "kiwi"};
  const std::string text = write_usda(scene);
  EXPECT_THAT(text, HasSubstr("float physics:mass = "));
  EXPECT_THAT(text, HasSubstr("token[] semantics:labels:category = [\"kiwi\"]"));
  EXPECT_THAT(text, HasSubstr("token[] semantics:labels:part = [\"skin\"]"));
  EXPECT_THAT(text, HasSubstr("string command = \"pomona cut kiwi --seed 0 --index 0 --knife half --piece 2"));
}

TEST(Usda, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = named::mixed();
  EXPECT_EQ(write_usda(scene, {.threads = {1}}), write_usda(scene, {.threads = {2}}));
}

}  // namespace
}  // namespace pomona
