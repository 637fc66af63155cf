#include "render/export/pov.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "render/export/pov_palette.h"
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

  // A different colour at every vertex: the number of textures stays within the limit for POV-Ray's memory.
  Solid& ball = scene.solids[0];
  for (std::size_t v = 0; v < ball.mesh.color.size(); ++v) ball.mesh.color[v] = 0.5f + 10.0f * ball.mesh.position[v];
  scene.solids[0] = ball;
  EXPECT_LE(occurrences(write_pov(scene, "x")[1].bytes, "texture{"), 4096u);
}

TEST(Pov, AHeapOfThousandsHasFewerColoursToCopyWithEachInstance) {
  Scene scene;
  scene.solids = {named::ball("ball", 0.05f, 40, Color(0.5f))};
  Solid& ball = scene.solids[0];
  for (std::size_t v = 0; v < ball.mesh.color.size(); ++v) ball.mesh.color[v] = 0.5f + 10.0f * ball.mesh.position[v];
  scene.instances.assign(10000, {0, {}, "one"});
  const std::vector<NamedFile> files = write_pov(scene, "x");
  EXPECT_EQ(occurrences(files[0].bytes, "object { Mesh_0 "), 10000u);
  EXPECT_EQ(occurrences(files[1].bytes, "mesh2"), 1u) << "a mesh is told once";
  const std::size_t textures = occurrences(files[1].bytes, "texture{");
  EXPECT_LE(10001 * textures, 2'000'000u);
  EXPECT_GT(textures, 150u);
}

TEST(PovPalette, KeepsColoursWhereTheyAreFewAndElsewhereTakesNearOnes) {
  const std::vector<pov::FinishedColor> few{{0, 0, 0, 0}, {252, 0, 0, 0}, {252, 0, 0, 1}};
  EXPECT_EQ(pov::few_colors(few, 3), few);

  // A cube of colours and a distant one: the distant one stays, and the others move by at most a box.
  std::vector<pov::FinishedColor> many{{252, 252, 252, 0}};
  for (int r = 0; r < 16; ++r)
    for (int g = 0; g < 16; ++g)
      for (int b = 0; b < 16; ++b) many.push_back({r, g, b, 0});
  const std::vector<pov::FinishedColor> taken = pov::few_colors(many, 65);
  EXPECT_EQ(taken[0], many[0]);
  EXPECT_EQ(std::set(taken.begin(), taken.end()).size(), 65u);
  for (std::size_t i = 0; i < many.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LE(std::abs(taken[i][k] - many[i][k]), 4);

  // Finishes are never mixed, even if that needs more textures.
  const std::vector<pov::FinishedColor> finishes = pov::few_colors({{9, 9, 9, 0}, {9, 9, 9, 1}, {9, 9, 9, 2}}, 1);
  EXPECT_EQ(std::set(finishes.begin(), finishes.end()).size(), 3u);
}

// POV-Ray 3.7 reads letters beyond ASCII as blanks.
TEST(Pov, TheIncludesNameIsAscii) {
  const std::vector<NamedFile> files = write_pov(named::axes_of_balls(),
                                                 "p\xc3\xaa"
                                                 "che",
                                                 {});
  EXPECT_EQ(files[0].name,
            "p\xc3\xaa"
            "che.pov");
  EXPECT_EQ(files[1].name, "p_c3_aache_meshes.inc");
  EXPECT_THAT(files[0].bytes, HasSubstr("#include \"p_c3_aache_meshes.inc\""));
}

TEST(Pov, NamesCannotBreakOut) {
  Scene scene = named::axes_of_balls();
  scene.solids[0].name = "a\n#error \"b\"";
  scene.instances[0].name = "c\r\n}";
  const std::vector<NamedFile> files = write_pov(scene, "d\"e\\f", {.provenance = "g\nh"});
  EXPECT_THAT(files[0].bytes, HasSubstr("\"d\\\"e_5cf_meshes.inc\""));
  EXPECT_THAT(files[0].bytes, HasSubstr("g h\n"));
  EXPECT_THAT(files[0].bytes, HasSubstr("// c  }\n"));
  EXPECT_THAT(files[1].bytes, HasSubstr("// a #error \"b\"\n"));
}

/// The three numbers after a word, searched from an offset on.
glm::dvec3 vector_after(const std::string& text, const std::string& word, std::size_t from = 0) {
  glm::dvec3 v(0);
  const char* at = text.c_str() + text.find('<', text.find(word, from)) + 1;
  for (int k = 0; k < 3; ++k) {
    char* end = nullptr;
    v[k] = std::strtod(at, &end);
    at = end + 1;
  }
  return v;
}

Style lit_from(double azimuth, double elevation) {
  Style style;
  style.light.azimuth = radians(azimuth);
  style.light.elevation = radians(elevation);
  return style;
}

TEST(Pov, TheLightComesFromWhereTheStyleHasIt) {
  // From the front, slightly above: +X is right, +Z is behind the camera.
  Scene scene = named::axes_of_balls();
  scene.view.target = {0.01, 0.02, 0.03};
  scene.view.eye = scene.view.target + glm::dvec3(0, 0.3, 0.4);
  const glm::dvec2 cases[] = {{0, 45}, {-90, 30}, {90, 10}, {180, 60}, {-54, 51}};
  for (const glm::dvec2& c : cases) {
    const std::string text = write_pov(scene, "x", {.style = lit_from(c.x, c.y)})[0].bytes;
    const double a = radians(c.x), e = radians(c.y);
    const glm::dvec3 expected(std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a));
    const glm::dvec3 place = 0.01 * vector_after(text, "light_source") - scene.view.target;
    EXPECT_LT(glm::distance(glm::normalize(place), expected), 1e-6) << c.x << " " << c.y;
  }
}

TEST(Pov, TheLightIsAsStrongAndAsWideAsTheStyleHasIt) {
  const Scene scene = named::axes_of_balls();
  Style style;
  const std::string usual = write_pov(scene, "x", {.style = style})[0].bytes;
  style.light.strength = 0.5;
  style.light.ambient = 2;
  style.light.softness = 0;
  const std::string other = write_pov(scene, "x", {.style = style})[0].bytes;
  const auto strength = [](const std::string& text) { return vector_after(text, "rgb", text.find("light_source")); };
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(strength(other)[k], 0.5 * strength(usual)[k], 1e-4);
    EXPECT_NEAR(vector_after(other, "ambient_light")[k], 2 * vector_after(usual, "ambient_light")[k], 1e-4);
  }
  EXPECT_EQ(occurrences(usual, "area_light"), 1u);
  EXPECT_EQ(occurrences(other, "area_light"), 0u);
}

TEST(Pov, WithoutShadowNoLightThrowsOne) {
  const Scene scene = named::axes_of_balls();
  Style style;
  const auto throwing = [&] {
    const std::string text = write_pov(scene, "x", {.style = style})[0].bytes;
    return occurrences(text, "light_source") - occurrences(text, "shadowless");
  };
  EXPECT_EQ(throwing(), 1u);
  style.shadow.strength = 0.4;
  EXPECT_EQ(throwing(), 1u);
  style.shadow.strength = 0;
  EXPECT_EQ(throwing(), 0u);
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

/// The box's cut face, number 0, has the finish of flesh and not that of skin, although both are of one part.
TEST(Pov, TheFirstCutFaceHasTheFinishOfFlesh) {
  Scene scene = named::with_materials();
  scene.solids[0].mesh.part.assign(scene.solids[0].mesh.part.size(), 0);
  const Solid& box = scene.solids[0];
  const auto cut = std::count(box.mesh.cut_face.begin(), box.mesh.cut_face.end(), 0);
  ASSERT_EQ(cut, 2);
  const std::string meshes = write_pov(scene, "x")[1].bytes;
  // The finish of each texture, then the textures of each triangle.
  const std::string mesh =
      meshes.substr(meshes.find("#declare Mesh_0 "), meshes.find("\n}\n") - meshes.find("#declare Mesh_0 "));
  std::vector<std::string> finishes;
  const std::regex texture("finish\\{(\\w+)\\}\\}"), face("<\\d+,\\d+,\\d+>,(\\d+),(\\d+),(\\d+)");
  for (std::sregex_iterator at(mesh.begin(), mesh.end(), texture), end; at != end; ++at) finishes.push_back((*at)[1]);
  std::map<std::string, std::ptrdiff_t> triangles;
  for (std::sregex_iterator at(mesh.begin(), mesh.end(), face), end; at != end; ++at)
    ++triangles[finishes.at(std::stoul((*at)[1]))];
  std::vector<std::ptrdiff_t> counts;
  for (const auto& [finish, count] : triangles) counts.push_back(count);
  EXPECT_THAT(counts, testing::UnorderedElementsAre(cut, 12 - cut));
}

/// The vectors of a list such as "vertex_vectors{3,\n<1,2,3>,...}", the first of its name.
std::vector<glm::dvec3> vectors_of(const std::string& text, const std::string& name) {
  const std::size_t begin = text.find(name + "{"), end = text.find('}', begin);
  const std::string list = text.substr(begin, end - begin);
  const std::regex vector("<(-?\\d+),(-?\\d+),(-?\\d+)>");
  std::vector<glm::dvec3> vectors;
  for (std::sregex_iterator at(list.begin(), list.end(), vector), last; at != last; ++at)
    vectors.emplace_back(std::stod((*at)[1]), std::stod((*at)[2]), std::stod((*at)[3]));
  return vectors;
}

TEST(Pov, NormalsOfABallPointOutOfIt) {
  Scene scene;
  scene.solids = {named::ball("ball", 0.05f, 6, Color(0.5f))};
  const std::string meshes = write_pov(scene, "x")[1].bytes;
  const std::vector<glm::dvec3> points = vectors_of(meshes, "vertex_vectors");
  const std::vector<glm::dvec3> normals = vectors_of(meshes, "normal_vectors");
  ASSERT_GT(points.size(), 100u);
  ASSERT_EQ(points.size(), normals.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_GT(glm::dot(glm::normalize(points[i]), glm::normalize(normals[i])), 0.999);
}

TEST(Pov, TheUnitFitsTheView) {
  Scene scene = named::axes_of_balls();
  EXPECT_THAT(write_pov(scene, "x")[0].bytes, HasSubstr("a unit is 1e-2 metres"));
  scene.view.eye *= 1000.0;
  scene.view.target *= 1000.0;
  EXPECT_THAT(write_pov(scene, "x")[0].bytes, HasSubstr("a unit is 1e1 metres"));
}

/// POV-Ray's own frame is left-handed, hence the minus in the file.
TEST(Pov, TheCameraSeesTheFieldAndIsRightHanded) {
  Scene scene = named::axes_of_balls();
  for (const double field : {0.2, 0.5, 1.0}) {
    scene.view.vertical_field = field;
    const std::string text = write_pov(scene, "x")[0].bytes;
    const auto number_after = [&](const std::string& words) {
      const std::size_t at = text.find(words);
      EXPECT_NE(at, std::string::npos) << words;
      return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + words.size(), nullptr);
    };
    EXPECT_NEAR(number_after("up y * "), 2 * std::tan(0.5 * field), 1e-9);
    EXPECT_NEAR(number_after("right -x * "), 2 * std::tan(0.5 * field), 1e-9);
    EXPECT_THAT(text, HasSubstr(" * image_width / image_height"));
  }
}

/// POV-Ray refuses a list that is shorter than it says, and one without commas.
TEST(Pov, ListsHaveAsManyEntriesAsTheySayWithCommasBetween) {
  const std::string meshes = write_pov(named::with_materials(), "x")[1].bytes;
  ASSERT_THAT(meshes, HasSubstr("#declare Fuzz_0 = mesh2"));
  const std::regex begin("(vertex_vectors|normal_vectors|face_indices) ?\\{(\\d+)");
  const std::regex entry("^,\\s*<-?\\d+,-?\\d+,-?\\d+>(,\\d+)*");
  std::size_t lists = 0;
  for (std::sregex_iterator at(meshes.begin(), meshes.end(), begin), end; at != end; ++at, ++lists) {
    auto place = meshes.cbegin() + at->position() + at->length();
    std::size_t entries = 0;
    std::smatch found;
    // One line at a time: a whole list is too long for std::regex.
    while (place != meshes.cend() && *place == ',') {
      const auto stop = std::find(std::find(place, meshes.cend(), '<'), meshes.cend(), '\n');
      const std::string line(place, stop);
      ASSERT_TRUE(std::regex_search(line, found, entry)) << (*at)[1] << ": " << line;
      place += found.length();
      ++entries;
    }
    EXPECT_EQ(entries, std::stoul((*at)[2])) << (*at)[1];
    ASSERT_NE(place, meshes.cend());
    while (*place == '\n' || *place == ' ') ++place;
    EXPECT_EQ(*place, '}') << (*at)[1];
  }
  EXPECT_GE(lists, 5u);
}

/// A shadow as white as the paper changes nothing, and causes no division by zero.
TEST(Pov, AWhiteShadowLeavesTheGroundItsNumbers) {
  Scene scene = named::mixed();
  Style style;
  style.shadow.strength = 1;
  style.shadow.color = Color(1);
  const std::string text = write_pov(scene, "x", {.style = style})[0].bytes;
  ASSERT_THAT(text, HasSubstr("color Paper * "));
  EXPECT_THAT(text, Not(HasSubstr("inf")));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
  const glm::dvec3 pigment = vector_after(text, "color Paper * ");
  for (int k = 0; k < 3; ++k) EXPECT_GT(pigment[k], 0);
}

}  // namespace
}  // namespace pomona
