#include "render/export/pov.h"

#include <gmock/gmock.h>

#include "tests/render/export/named_solids.h"

namespace pomona {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(Pov, DeclaresEachMeshOnceAndPlacesItAsOftenAsAsked) {
  const std::vector<NamedFile> files = write_pov(named::mixed(), "mixed");
  ASSERT_EQ(files.size(), 2u);
  EXPECT_EQ(files[0].name, "mixed.pov");
  EXPECT_EQ(files[1].name, "mixed_meshes.inc");
  EXPECT_EQ(occurrences(files[1].bytes, "mesh2"), 3u);
  EXPECT_EQ(occurrences(files[0].bytes, "object { Mesh_0 "), 2u);
  EXPECT_EQ(occurrences(files[0].bytes, "object { Mesh_2 "), 0u) << "there is nothing to place";
  EXPECT_THAT(files[0].bytes, HasSubstr("assumed_gamma 1.0"));
  EXPECT_THAT(files[0].bytes, HasSubstr("#include \"mixed_meshes.inc\""));
}

TEST(Pov, NothingIsRandomOrDependsOnThreads) {
  const Scene scene = named::mixed();
  const auto one = write_pov(scene, "x", {.threads = {1}}), two = write_pov(scene, "x", {.threads = {2}});
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].bytes, two[i].bytes);
  EXPECT_THAT(one[0].bytes, Not(HasSubstr("jitter")));
  EXPECT_THAT(one[0].bytes, Not(HasSubstr("radiosity")));
}

TEST(Pov, TexturesAreSharedAndBounded) {
  // One colour, many vertices: one texture.
  Scene scene;
  scene.solids = {named::ball("ball", 0.05f, 20, Color(0.5f))};
  EXPECT_THAT(write_pov(scene, "x")[1].bytes, HasSubstr("texture_list{1,"));

  // A different colour at every vertex: no more than POV-Ray's memory should bear.
  Solid& ball = scene.solids[0];
  for (std::size_t v = 0; v < ball.color.size(); ++v) ball.color[v] = 0.5f + 10.0f * ball.position[v];
  scene.solids[0] = ball;
  EXPECT_LE(occurrences(write_pov(scene, "x")[1].bytes, "texture{"), 4096u);
}

TEST(Pov, NamesCannotBreakOut) {
  Scene scene = named::axes_of_balls();
  scene.solids[0].name = "a\n#error \"b\"";
  scene.instances[0].name = "c\r\n}";
  const std::vector<NamedFile> files = write_pov(scene, "d\"e\\f", {.provenance = "g\nh"});
  EXPECT_THAT(files[0].bytes, HasSubstr("\"d\\\"e\\\\f_meshes.inc\""));
  EXPECT_THAT(files[0].bytes, HasSubstr("g h\n"));
  EXPECT_THAT(files[0].bytes, HasSubstr("// c  }\n"));
  EXPECT_THAT(files[1].bytes, HasSubstr("// a #error \"b\"\n"));
}

TEST(Pov, EachMaterialHasAFinish) {
  const std::vector<NamedFile> files = write_pov(named::with_materials(), "x");
  EXPECT_THAT(files[0].bytes, HasSubstr("#declare Skin = finish"));
  EXPECT_THAT(files[0].bytes, HasSubstr("#if (Subsurface) subsurface { translucency rgb <4, 2, 1> } #end"));
  EXPECT_THAT(files[0].bytes, HasSubstr("#ifndef (Subsurface)"));
  EXPECT_THAT(files[1].bytes, HasSubstr("finish{Finish_2}"));
  EXPECT_THAT(files[1].bytes, HasSubstr("interior { ior"));
  EXPECT_THAT(files[1].bytes, HasSubstr("#declare Fuzz_0 = mesh2"));
  EXPECT_EQ(occurrences(files[0].bytes, "object { Fuzz_0 "), 1u);
  const std::vector<NamedFile> plain = write_pov(named::mixed(), "x");
  EXPECT_THAT(plain[0].bytes, Not(HasSubstr("Subsurface")));
  EXPECT_THAT(plain[1].bytes, Not(HasSubstr("Finish_")));
}

TEST(Pov, TheUnitFitsTheView) {
  Scene scene = named::axes_of_balls();
  EXPECT_THAT(write_pov(scene, "x")[0].bytes, HasSubstr("a unit is 1e-2 metres"));
  scene.view.eye *= 1000.0;
  scene.view.target *= 1000.0;
  EXPECT_THAT(write_pov(scene, "x")[0].bytes, HasSubstr("a unit is 1e1 metres"));
}

}  // namespace
}  // namespace pomona
