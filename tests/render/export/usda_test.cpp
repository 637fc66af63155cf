// USD as text; in tests/programs/usd_test.mjs another program reads it.
#include "render/export/usd/write_usda.h"

#include <gmock/gmock.h>
#include <sstream>

#include "generator/base/error.h"
#include "render/export/usd/usda_text.h"
#include "render/style/style_file.h"
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
    append_number(text, number, 1e-7);
    text += ' ';
  }
  EXPECT_EQ(text, "0.1234568 0 12 -0.5 ");
  EXPECT_EQ(usd::quoted("a\"b\\c\nd"), "\"a\\\"b\\\\c d\"");
}

TEST(Usda, TheCameraIsTheActiveOneWhateverItIsCalled) {
  Scene scene = named::mixed();
  scene.instances[0].name = "view";
  scene.solids[0].origin = {};
  const std::string text = write_usda(scene);
  EXPECT_THAT(text, HasSubstr("def Camera \"view_2\""));
  EXPECT_THAT(text, HasSubstr("string boundCamera = \"/Scene/view_2\""));
  EXPECT_THAT(text, HasSubstr("rel camera = </Scene/view_2>"));
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

/// A scene of one piece of fruit and one dish.
Scene piece_in_dish() {
  Scene scene = named::mixed();
  scene.solids[0].origin = {.source = "kiwi", .number = 1, .pieces = 1, .fruit = "kiwi"};
  return scene;
}

TEST(Usda, PiecesMoveAndDishesStandStill) {
  const std::string text = write_usda(piece_in_dish());
  EXPECT_EQ(occurrences(text, "\"PhysicsRigidBodyAPI\""), 1u);
  EXPECT_EQ(occurrences(text, "approximation = \"convexHull\""), 1u) << "the piece collides by its hull";
  EXPECT_EQ(occurrences(text, "approximation = \"none\""), 2u) << "the others by their triangles";
  EXPECT_EQ(occurrences(text, "physics:diagonalInertia"), occurrences(text, "physics:principalAxes"));
}

TEST(Usda, HullsTakeTheMeshesPlace) {
  Scene scene = piece_in_dish();
  const std::string text = write_usda(scene, {.hulls = 4});
  EXPECT_EQ(occurrences(text, "def Mesh \"hull_"), 1u) << "a box is convex";
  EXPECT_EQ(occurrences(text, "uniform token purpose = \"guide\""), 1u);
  EXPECT_EQ(occurrences(text, "approximation = \"convexHull\""), 1u);
}

/// Copies refer to the same mesh, and have shapes of their own.
TEST(Usda, ShapesOfSettledPiecesLeaveRoomForEachOther) {
  const std::string text = write_usda(named::settled_balls());
  EXPECT_EQ(occurrences(text, "def Mesh \"mesh\""), 3u);
  EXPECT_EQ(occurrences(text, "def Mesh \"hull_1\""), 4u);
  EXPECT_EQ(occurrences(text, "bool physics:collisionEnabled = 0"), 4u);
  EXPECT_EQ(occurrences(text, "prepend references = </Pieces/copied>"), 2u);
  EXPECT_EQ(occurrences(text, "prepend inherits = </Pieces/copied_settled"), 2u);
  const std::string several = write_usda(named::settled_balls(), {.hulls = 4});
  EXPECT_EQ(occurrences(several, "bool physics:collisionEnabled = 0"), 0u) << "parts take the place of parts";
  EXPECT_EQ(occurrences(write_usda(named::settled_balls(), {.instances = true}), "def Mesh \"hull_"), 0u);
}

/// Joined pieces begin within each other's hulls; once a joint has broken, they must not push each other away.
TEST(Usda, WeldedBodiesWhoseHullsOverlapDoNotCollide) {
  const std::string text = write_usda(named::settled_balls(), {.welded = true});
  EXPECT_EQ(occurrences(text, "prepend apiSchemas = [\"PhysicsFilteredPairsAPI\"]"), 2u);
  EXPECT_THAT(text, testing::ContainsRegex("rel physics:filteredPairs = \\[</Scene/[a-z_/]*ball_1>\\]"));
  EXPECT_THAT(text, testing::ContainsRegex("rel physics:filteredPairs = \\[</Scene/[a-z_/]*ball_3>\\]"));
  EXPECT_EQ(occurrences(write_usda(named::settled_balls()), "filteredPairs"), 0u) << "there shapes are cut apart";
  EXPECT_EQ(occurrences(write_usda(named::settled_balls(), {.instances = true, .welded = true}), "filteredPairs"), 0u);
}

TEST(Usda, ZMayPointUp) {
  Scene scene = named::mixed();
  scene.instances.resize(1);
  scene.instances[0].pose = {.rotation = {1, 0, 0, 0}, .translation = {1, 2, 3}};
  scene.solids[0].origin = {};
  const std::string text = write_usda(scene, {.up = UpAxis::z});
  EXPECT_THAT(text, HasSubstr("upAxis = \"Z\""));
  EXPECT_THAT(text, HasSubstr("xformOp:translate = (1, -3, 2)"));
  EXPECT_THAT(text, HasSubstr("quatd xformOp:orient = (0.7071067811865476, 0.7071067811865476, 0, 0)"));
}

TEST(Usda, AllButClassesIsBelowOneRoot) {
  std::istringstream lines(write_usda(named::with_materials()));
  int depth = 0, roots = 0;
  for (std::string line; std::getline(lines, line);) {
    if (depth == 0 && line.starts_with("def ")) ++roots;
    const std::size_t last = line.find_last_not_of(' ');
    if (last != std::string::npos && line[last] == '{') ++depth;
    if (last != std::string::npos && line[last] == '}' && line.find('{') == std::string::npos) --depth;
  }
  EXPECT_EQ(roots, 1);
  EXPECT_EQ(depth, 0);
}

/// The scene's solids on atlases of a texel each.
std::vector<BakedSolid> on_atlases(const Scene& scene) {
  std::vector<BakedSolid> baked;
  for (const Solid& solid : scene.solids) {
    BakedSolid one{.solid = solid, .uv = {}, .texture = {1, 1, {glm::u8vec3(9)}}};
    one.uv.resize(solid.mesh.position.size(), {0.25f, 0.25f});
    baked.push_back(std::move(one));
  }
  return baked;
}

/// The points of all convex parts, in their order.
std::vector<std::string> hull_points(const std::string& text) {
  std::vector<std::string> found;
  for (std::size_t at = text.find("def Mesh \"hull_"); at != std::string::npos;
       at = text.find("def Mesh \"hull_", at)) {
    at = text.find("point3f[] points", at);
    found.push_back(text.substr(at, text.find('\n', at) - at));
  }
  return found;
}

/// On an atlas triangles stand in another order, which would divide a piece otherwise: here one shows which is asked.
TEST(Usda, ShapesAreThoseOfTheSolidWithTexturesToo) {
  const Scene scene = named::settled_balls();
  std::vector<BakedSolid> baked = on_atlases(scene);
  for (BakedSolid& one : baked)
    for (glm::vec3& p : one.solid.mesh.position) p *= 0.5f;
  const std::vector<std::string> plain = hull_points(write_usda(scene, {.hulls = 4}));
  EXPECT_GE(plain.size(), 7u) << "three balls, and four places";
  EXPECT_EQ(hull_points(write_usda(scene, baked, "balls", {.hulls = 4}).text), plain);
}

TEST(Usda, ColoursInTexturesAreChosenByVariants) {
  const Scene scene = named::with_materials();
  const std::vector<BakedSolid> baked = on_atlases(scene);
  const std::vector<TextureVariant> variants{{"ripeness 0.2", baked}, {"ripeness 1.8", baked}};
  const UsdaFiles plain = write_usda(scene, baked, "dish"), chosen = write_usda(scene, baked, "dish", {}, {}, variants);

  // A texture for each solid with triangles and each ripeness; vertices have no colours.
  const std::size_t solids = occurrences(plain.text, "def Mesh ");
  ASSERT_GE(solids, 1u);
  EXPECT_EQ(plain.textures.size(), solids);
  EXPECT_EQ(chosen.textures.size(), 3 * solids);
  EXPECT_EQ(occurrences(plain.text, "primvars:st ="), solids);
  EXPECT_EQ(occurrences(plain.text, "primvars:displayColor ="), 0u);
  EXPECT_THAT(plain.text, HasSubstr("(0.25, 0.75)")) << "rows are counted from the bottom";
  for (const UsdaFiles& files : {plain, chosen})
    for (const NamedFile& file : files.textures) EXPECT_THAT(files.text, HasSubstr("@./" + file.name + "@"));

  // A prim's own values win over its variants: so with variants only these name files.
  EXPECT_EQ(occurrences(plain.text, "variantSet "), 0u);
  EXPECT_EQ(occurrences(chosen.text, "variantSet \"ripeness\" = {"), solids);
  EXPECT_EQ(occurrences(chosen.text, "\"ripeness_1_8\" {"), solids);
  EXPECT_EQ(occurrences(chosen.text, "asset inputs:file"), 3 * occurrences(plain.text, "asset inputs:file"));
  EXPECT_EQ(chosen.text.find("asset inputs:file") > chosen.text.find("variantSet "), true);
}

/// One material a piece; what it rubs by stays the look of its parts.
TEST(Usda, MapsMayTellLooks) {
  const Scene scene = named::with_materials();
  const std::string by_look = write_usda(scene);
  EXPECT_GT(occurrences(by_look, "familyName = \"materialBind\""), 1u);
  const UsdaFiles painted = write_usda(scene, "dish", {.atlas = AtlasOf::file});
  const std::vector<BakedSolid> baked =
      all_baked(scene.solids, style_named("plain"), {.texels = 64, .maps = Maps::all, .looks = true});
  const UsdaFiles textured = write_usda(scene, baked, "dish");
  for (const UsdaFiles& files : {painted, textured}) {
    EXPECT_EQ(occurrences(files.text, "familyName = \"materialBind\""), 0u);
    EXPECT_EQ(occurrences(files.text, "rel material:binding = "), 1u);
    EXPECT_EQ(occurrences(files.text, "rel material:binding:physics = "), 1u);
    EXPECT_THAT(files.text, HasSubstr("float inputs:roughness.connect = <../orm.outputs:g>"));
    EXPECT_THAT(files.text, HasSubstr("float inputs:clearcoat.connect = <../coat.outputs:r>"));
    EXPECT_EQ(occurrences(files.text, "primvars:st ="), 1u);
    for (const NamedFile& file : files.textures) EXPECT_THAT(files.text, HasSubstr("@./" + file.name + "@"));
  }
  EXPECT_EQ(painted.textures.size(), 3u) << "roughness, coat, sheen";
  EXPECT_EQ(painted.textures[0].name, "dish_looks_orm.png");
  EXPECT_EQ(occurrences(painted.text, "primvars:displayColor ="), 1u);
  EXPECT_EQ(textured.textures.size(), 5u) << "colours and relief, too";
  EXPECT_EQ(occurrences(textured.text, "primvars:displayColor ="), 0u);
}

TEST(Usda, VariantsOfAnotherAtlasAreAnError) {
  const Scene scene = named::with_materials();
  const std::vector<BakedSolid> baked = on_atlases(scene);
  std::vector<TextureVariant> variants{{"riper", baked}};
  for (BakedSolid& solid : variants[0].solids) solid.uv.assign(solid.uv.size(), {0.5f, 0.5f});
  EXPECT_THROW(write_usda(scene, baked, "dish", {}, {}, variants), Error);
}

TEST(Usda, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = named::mixed();
  EXPECT_EQ(write_usda(scene, {.threads = {1}}), write_usda(scene, {.threads = {2}}));
}

TEST(Usda, BracesEndWhereTheirLinesBegan) {
  const Scene scene = named::with_materials();
  std::vector<std::vector<Solid>> levels{{scene.solids[0]}};
  levels.resize(scene.solids.size());
  std::istringstream lines(write_usda(scene, {}, levels));
  std::vector<std::size_t> open;
  std::size_t pairs = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t indent = line.find_first_not_of(' ');
    if (indent == std::string::npos) continue;
    if (line[indent] == '}') {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(indent, open.back()) << line;
      open.pop_back();
      ++pairs;
    }
    // In USD the brace is on its own line below its owner, except for variants.
    if (line.back() == '{') open.push_back(indent);
  }
  EXPECT_TRUE(open.empty());
  EXPECT_GT(pairs, 10u);
}

TEST(Usda, TellsLightUnderTheSurfaceInOpenPbr) {
  Scene scene = named::with_materials();
  MaterialSketch& flesh = scene.solids[0].own_look().materials[1];
  flesh.subsurface = Subsurface{.radius = 0.004, .tint = {1, 0.5f, 0.25f}, .weight = 0.7};
  flesh.transmission = 0.25;
  const std::string text = write_usda(scene);
  EXPECT_EQ(occurrences(text, "ND_open_pbr_surface_surfaceshader"), occurrences(text, "\"UsdPreviewSurface\""));
  EXPECT_EQ(occurrences(text, "outputs:mtlx:surface.connect = <light.outputs:out>"),
            occurrences(text, "outputs:surface.connect = <surface.outputs:surface>"));
  EXPECT_THAT(text, HasSubstr("subsurface_weight = 0.7\n"));
  EXPECT_THAT(text, HasSubstr("subsurface_radius = 0.004\n"));
  EXPECT_THAT(text, HasSubstr("subsurface_radius_scale = (1, 0.5, 0.25)\n"));
  EXPECT_EQ(occurrences(text, "transmission_weight = 0.25\n"), 1u);
}

TEST(Usda, ShinyPartsAloneHaveAClearCoat) {
  Scene scene = named::with_materials();
  scene.solids[0].own_look().materials[1].wet = 0;
  const std::string text = write_usda(scene);
  ASSERT_EQ(occurrences(text, "UsdPreviewSurface"), 2u) << "skin and flesh";
  const std::string words = "float inputs:clearcoat = ";
  ASSERT_EQ(occurrences(text, words), 1u);
  EXPECT_GT(std::stod(text.substr(text.find(words) + words.size())), 0.1);
}

}  // namespace
}  // namespace pomona
