#include "generator/scene/compose.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/scene/layout_file.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

const fs::path source_dir = POMONA_SOURCE_DIR;

ComposeOptions coarse() {
  ComposeOptions options;
  options.find_template = [](const std::string& name) { return source_dir / "templates" / (name + ".toml"); };
  options.detail = 0.4;
  options.cut.coarsest = 1.0 / 15;
  options.cut.finest = 1.0 / 60;
  return options;
}

const std::string head = "format = 1\nname = \"dish\"\nseed = 3\n";
const std::string wedges = "[[pieces]]\nname = \"wedges\"\ntemplate = \"tomato\"\nknives = [\"wedges:5\"]\ntake = 2\n";
const std::string rings =
    "[[pieces]]\nname = \"rings\"\ntemplate = \"pepper\"\nknives = [\"slices:9mm\"]\ntake = 1\ncount = 2\n";

const Solid& named(const SceneParts& parts, const std::string& name) {
  for (const Solid& solid : parts.solids)
    if (solid.name == name) return solid;
  throw Error(ExitStatus::bug, "no solid " + name);
}

TEST(Compose, AddingAnEntryDoesNotChangeTheOthers) {
  const SceneParts alone = make_parts(parse_scene(head + wedges, "a.toml"), nullptr, coarse());
  const SceneParts both = make_parts(parse_scene(head + rings + wedges, "a.toml"), nullptr, coarse());
  ASSERT_EQ(alone.solids.size(), 2u);
  ASSERT_EQ(both.solids.size(), 4u);
  for (const Solid& solid : alone.solids) EXPECT_EQ(named(both, solid.name).position, solid.position);
}

TEST(Compose, SeedsAndNumbersGiveDifferentVariants) {
  SceneDescription scene = parse_scene(head + rings, "a.toml");
  const SceneParts three = make_parts(scene, nullptr, coarse());
  scene.seed = 0;
  const SceneParts zero = make_parts(scene, nullptr, coarse());
  ASSERT_EQ(three.solids.size(), 2u);
  EXPECT_NE(three.solids[0].position, three.solids[1].position);
  EXPECT_NE(three.solids[0].position, zero.solids[0].position);
}

TEST(Compose, CopiesShareOneSolid) {
  const SceneParts parts = make_parts(parse_scene(head + wedges + "copies = 3\n", "a.toml"), nullptr, coarse());
  EXPECT_EQ(parts.solids.size(), 2u);
  EXPECT_EQ(parts.items.size(), 6u);
  EXPECT_THAT(parts.items[1].name, testing::EndsWith(".copy-2"));
}

/// A ball out of the middle, and what is around it.
TEST(Compose, PiecesWithoutSkinArePieces) {
  const std::string balls =
      "[[pieces]]\nname = \"ball\"\ntemplate = \"radish\"\nas_drawn = true\nknives = [\"ball:8mm,at=0,32mm,0\"]\n";
  const SceneParts parts = make_parts(parse_scene(head + balls + "smallest = 0.001\n", "a.toml"), nullptr, coarse());
  EXPECT_EQ(parts.solids.size(), 2u);
  EXPECT_EQ(parts.items.size(), 2u);
}

TEST(Compose, ATemplateThatIsNotThereIsToldInTheScene) {
  ComposeOptions options;
  options.find_template = [](const std::string&) -> fs::path { throw Error(ExitStatus::input_missing, "no template"); };
  try {
    make_parts(parse_scene(head + wedges, "a.toml"), nullptr, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::input_missing);
    EXPECT_THAT(to_string(error.diagnostics().front()), testing::StartsWith("a.toml:6:12: error: no template"));
  }
}

/// The dish itself, coarse and uncoloured: all pieces touch without overlap, and lie in the bowl.
TEST(Compose, TheSaladSettles) {
  const Composition salad = compose(read_scene(source_dir / "scenes/salad.toml"), nullptr, coarse());
  EXPECT_GE(salad.report.counts.at("variants"), 30);
  EXPECT_GE(salad.report.counts.at("pieces"), 60);
  ASSERT_EQ(salad.report.fits.size(), static_cast<std::size_t>(salad.report.counts.at("pieces")));
  for (const Fit& fit : salad.report.fits) {
    EXPECT_LE(fit.gap, 0.02);
    EXPECT_LE(fit.penetration, 0.02);
  }
}

}  // namespace
}  // namespace pomona
