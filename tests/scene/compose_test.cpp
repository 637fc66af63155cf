#include "generator/scene/compose.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "generator/scene/layout_file.h"
#include "tests/base/temporary_folder.h"

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
  for (const Solid& solid : alone.solids) EXPECT_EQ(named(both, solid.name).mesh.position, solid.mesh.position);
}

TEST(Compose, SeedsAndNumbersGiveDifferentVariants) {
  SceneDescription scene = parse_scene(head + rings, "a.toml");
  const SceneParts three = make_parts(scene, nullptr, coarse());
  scene.seed = 0;
  const SceneParts zero = make_parts(scene, nullptr, coarse());
  ASSERT_EQ(three.solids.size(), 2u);
  EXPECT_NE(three.solids[0].mesh.position, three.solids[1].mesh.position);
  EXPECT_NE(three.solids[0].mesh.position, zero.solids[0].mesh.position);
}

TEST(Compose, CopiesShareOneSolid) {
  const SceneParts parts = make_parts(parse_scene(head + wedges + "copies = 3\n", "a.toml"), nullptr, coarse());
  EXPECT_EQ(parts.solids.size(), 2u);
  EXPECT_EQ(parts.items.size(), 6u);
  EXPECT_THAT(parts.items[1].name, testing::EndsWith(".copy-2"));
}

/// A ball cut from the middle, and the rest.
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

/// Shares of a total are whole numbers, and the pieces of an entry are placed equally often, up to one.
TEST(Compose, SharesAreDealtOut) {
  const std::string shared = "total = 11\n" + wedges + "share = 2\n" + rings + "share = 1\n";
  const SceneParts parts = make_parts(parse_scene(head + shared, "a.toml"), nullptr, coarse());
  ASSERT_EQ(parts.items.size(), 11u);
  std::map<int, int> times;
  for (const SettleItem& item : parts.items) ++times[item.solid];
  EXPECT_EQ(times, (std::map<int, int>{{0, 4}, {1, 3}, {2, 2}, {3, 2}}));
}

TEST(Compose, SizesAreTimesTheVariantsOwn) {
  const auto radius = [](const SceneParts& parts) {
    double max = 0;
    for (const glm::vec3& p : parts.solids[0].mesh.position) max = std::max(max, std::hypot(double{p.x}, double{p.z}));
    return max;
  };
  const SceneParts plain = make_parts(parse_scene(head + wedges, "a.toml"), nullptr, coarse());
  const SceneParts small = make_parts(parse_scene(head + wedges + "size = 0.5\n", "a.toml"), nullptr, coarse());
  EXPECT_NEAR(radius(small), 0.5 * radius(plain), 1e-3);
}

/// Solids that are streamed are taken once each, in the scene's order; what remains of them is enough to settle.
TEST(Compose, SolidsAreTakenInTheirOrderAndTheirLooksLetGo) {
  const std::string many = "[bowl]\nprofile = \"M 0 0 L 80 0 L 130 -60 L 126 -60 L 78 -4 L 0 -4\"\n" + wedges +
                           "count = 20\ntotal = 30\n" + rings;
  const SceneDescription scene = parse_scene(head + many, "a.toml");
  const Composition whole = compose(scene, nullptr, coarse());
  for (const int threads : {1, 2}) {
    ComposeOptions options = coarse();
    options.threads = {threads};
    std::vector<Solid> taken;
    std::size_t max = 0;
    options.take = [&](std::span<const Solid> solids) {
      max = std::max(max, solids.size());
      taken.insert(taken.end(), solids.begin(), solids.end());
    };
    const Composition streamed = compose(scene, nullptr, options);
    ASSERT_EQ(taken.size(), whole.scene.solids.size());
    ASSERT_EQ(streamed.scene.solids.size(), whole.scene.solids.size());
    EXPECT_LT(max, taken.size() - 1) << "one after another, not all at the end";
    for (std::size_t i = 0; i < taken.size(); ++i) {
      const Solid &expected = whole.scene.solids[i], &kept = streamed.scene.solids[i];
      EXPECT_EQ(taken[i].name, expected.name);
      EXPECT_EQ(taken[i].mesh.color, expected.mesh.color);
      EXPECT_EQ(kept.name, expected.name);
      EXPECT_EQ(kept.mesh.position, expected.mesh.position);
      EXPECT_TRUE(kept.mesh.color.empty() && kept.mesh.normal.empty() && kept.mesh.surface.empty());
    }
    EXPECT_EQ(write_layout(streamed.scene), write_layout(whole.scene));
    EXPECT_EQ(streamed.scene.view.eye, whole.scene.view.eye);
  }
}

TEST(Compose, WhatTakesSolidsMayFail) {
  ComposeOptions options = coarse();
  options.threads = {2};
  options.take = [](std::span<const Solid>) { throw Error(ExitStatus::io_error, "the disk is full"); };
  try {
    compose(parse_scene(head + wedges, "a.toml"), nullptr, options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::io_error);
  }
}

/// Two crates with one mesh share a solid, and each heap lies in its crate.
class Dishes : public testing::Test {
 protected:
  Dishes() {
    std::ofstream(folder_.path() / "tray.obj") << tray();
    std::ofstream(folder_.path() / "line.obj") << "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n";
  }

  SceneDescription scene(const std::string& text) const {
    return parse_scene(head + text, (folder_.path() / "a.toml").string());
  }

  /// A tray of 30 x 20 cm, 8 cm high, in centimetres.
  static std::string tray() {
    std::string text;
    int first = 1;
    const auto box = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
      for (int i = 0; i < 8; ++i) {
        text += "v " + std::to_string((i & 1) != 0 ? x1 : x0) + " " + std::to_string((i & 2) != 0 ? y1 : y0) + " " +
                std::to_string((i & 4) != 0 ? z1 : z0) + "\n";
      }
      for (const auto& f : {std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}, std::array{0, 1, 5, 4},
                            std::array{2, 6, 7, 3}, std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}}) {
        text += "f";
        for (const int corner : f) text += " " + std::to_string(first + corner);
        text += "\n";
      }
      first += 8;
    };
    box(-15, 0, -10, 15, 1, 10);
    box(-15, 0, -10, -14, 8, 10);
    box(14, 0, -10, 15, 8, 10);
    box(-15, 0, -10, 15, 8, -9);
    box(-15, 0, 9, 15, 8, 10);
    return text;
  }

  TemporaryFolder folder_;
};

const std::string two_trays =
    "[[dishes]]\nname = \"left\"\nmesh = \"tray.obj\"\nunit = \"1cm\"\nat = [\"-20cm\", \"3cm\", \"0cm\"]\nturn = 90\n"
    "[[dishes]]\nname = \"right\"\nmesh = \"tray.obj\"\nunit = \"1cm\"\nat = [\"20cm\", \"0cm\", \"0cm\"]\n";
const std::string cherries = "[[pieces]]\nname = \"cherry\"\ntemplate = \"radish\"\nas_drawn = true\n";

TEST_F(Dishes, HoldHeapsOfTheirOwn) {
  const Composition both = compose(
      scene(two_trays + cherries + "total = 7\nin = \"left\"\n" +
            "[[pieces]]\nname = \"other\"\ntemplate = \"radish\"\nas_drawn = true\ntotal = 7\nin = \"right\"\n"),
      nullptr, coarse());
  ASSERT_EQ(both.scene.instances.size(), 16u);
  EXPECT_EQ(both.scene.instances[0].solid, both.scene.instances[1].solid);
  EXPECT_EQ(both.report.counts.at("heaps"), 2);
  EXPECT_THAT(both.report.warnings, testing::IsEmpty());
  EXPECT_TRUE(both.scene.ground);
  const Solid& crate = both.scene.solids[static_cast<std::size_t>(both.scene.instances[0].solid)];
  EXPECT_EQ(crate.look->part_names, std::vector<std::string>{"dish"});
  for (const std::int32_t part : crate.mesh.part) EXPECT_EQ(part, 0);
  for (std::size_t i = 2; i < 16; ++i) {
    const Instance& instance = both.scene.instances[i];
    const bool left = i < 9;
    for (const glm::vec3& p : both.scene.solids[static_cast<std::size_t>(instance.solid)].mesh.position) {
      const glm::dvec3 at = instance.pose.rotation * glm::dvec3(p) + instance.pose.translation;
      const glm::dvec2 away = glm::abs(glm::dvec2(at.x - (left ? -0.2 : 0.2), at.z));
      ASSERT_LT(away.x, left ? 0.101 : 0.151) << i;
      ASSERT_LT(away.y, left ? 0.151 : 0.101) << i;
      ASSERT_GT(at.y, left ? 0.038 : 0.008) << i;
    }
  }
  for (const Fit& fit : both.report.fits) {
    EXPECT_LE(fit.gap, 0.02);
    EXPECT_LE(fit.penetration, 0.02);
  }
}

TEST_F(Dishes, WhatTheirFilesLeaveOpenIsTold) {
  std::ofstream(folder_.path() / "noted.obj") << tray() << "f 1 2\n";
  const Composition one = compose(
      scene("[[dishes]]\nname = \"d\"\nmesh = \"noted.obj\"\nunit = \"1cm\"\n" + cherries + "total = 1\nin = \"d\"\n"),
      nullptr, coarse());
  EXPECT_THAT(one.report.warnings, testing::ElementsAre("dish \"d\": a face of less than three corners is left out"));
}

TEST_F(Dishes, ThatCannotBeAreToldInTheScene) {
  const auto told = [&](const std::string& text, ExitStatus status) {
    try {
      compose(scene(text), nullptr, coarse());
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), status);
      return to_string(error.diagnostics().front());
    }
    return std::string("nothing");
  };
  const std::string file = (folder_.path() / "a.toml").string();
  const auto dish = [](const std::string& mesh) { return "[[dishes]]\nname = \"d\"\nmesh = \"" + mesh + "\"\n"; };
  EXPECT_THAT(told(dish("none.obj") + cherries, ExitStatus::input_missing),
              testing::AllOf(testing::StartsWith(file + ":6:8: error: dish \"d\""),
                             testing::HasSubstr("there is no such file")));
  EXPECT_THAT(told(dish("line.obj") + cherries + "on = \"d\"\nwhere = { kind = \"scatter\" }\n", ExitStatus::bad_data),
              testing::AllOf(testing::StartsWith(file + ":6:8: error: "), testing::HasSubstr("no area")));
  EXPECT_THAT(
      told("settle.attempts = 1\n" + dish("tray.obj") + "unit = \"4mm\"\n" + cherries + "total = 30\nin = \"d\"\n",
           ExitStatus::some_items_failed),
      testing::AllOf(testing::StartsWith(file + ":10:8: error: "), testing::ContainsRegex("piece \"cherry-1")));
  EXPECT_THAT(told("[bowl]\nprofile = \"M 0 0 L 60 0 L 60 -5 L 0 -5\"\n" + cherries, ExitStatus::bad_data),
              testing::AllOf(testing::StartsWith(file + ":7:8: error: "), testing::HasSubstr("no hollow")));
}

/// A smaller salad, coarse and without colours: all pieces touch without overlap and lie in the bowl.
TEST(Compose, TheSaladSettles) {
  SceneDescription scene = read_scene(source_dir / "scenes/salad.toml");
  scene.total = 40;
  const Composition salad = compose(scene, nullptr, coarse());
  EXPECT_EQ(salad.report.counts.at("pieces"), 40);
  ASSERT_EQ(salad.report.fits.size(), 40u);
  for (const Fit& fit : salad.report.fits) {
    EXPECT_LE(fit.gap, 0.02);
    EXPECT_LE(fit.penetration, 0.02);
  }
}

}  // namespace
}  // namespace pomona
