#include "generator/template/read/read_template.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/base/random.h"
#include "generator/base/units.h"
#include "generator/template/half_wall.h"
#include "tests/template/plum.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;
const fs::path root(POMONA_SOURCE_DIR);

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<fs::path> good_files() {
  std::vector<fs::path> files{root / "tests/template/good.toml"};
  for (const auto& entry : fs::directory_iterator(root / "templates")) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// good.toml with one text replaced by another.
Template plum_with(const std::string& from, const std::string& to) {
  std::string text = text_of(root / "tests/template/good.toml");
  text.replace(text.find(from), from.size(), to);
  return parse_template(text, "plum.toml");
}

TEST(HalfWall, is_told_where_a_half_would_show_the_wall_between_chambers) {
  const std::string loop = R"(horizontal = "M 2 -5 L 2 -15 L -2 -15 L -2 -5 Z")";
  const std::string loops = R"(horizontal = ["M 2 -5 L 2 -15 L -2 -15 L -2 -5 Z", "M -2 5 L -2 15 L 2 15 L 2 5 Z"])";
  std::string text = text_of(root / "tests/template/good.toml");
  text.replace(text.find(loop), loop.size(), loops);
  EXPECT_EQ(half_wall_warnings(parse_template(text, "plum.toml")).size(), 2u);  // folds from 0 and from 180 degrees
  text.replace(text.find("folds = 2"), 9, "folds = 2\nfold_angles = [40, 220]");
  EXPECT_TRUE(half_wall_warnings(parse_template(text, "plum.toml")).empty());
  for (const fs::path& file : good_files()) {
    if (file.parent_path() != root / "templates") continue;
    EXPECT_TRUE(half_wall_warnings(read_template(file)).empty()) << file;
  }
}

TEST(ReadTemplate, all_templates_of_the_project_are_good) {
  const auto files = good_files();
  EXPECT_GE(files.size(), 4u);
  for (const fs::path& file : files) {
    SCOPED_TRACE(file);
    const Template fruit = read_template(file);
    if (file.parent_path() != root / "tests/template") {
      EXPECT_EQ(fruit.name, file.stem().string());
    }
    EXPECT_FALSE(fruit.surfaces.empty() && fruit.meshes.empty());
  }
}

TEST(ReadTemplate, the_fruit_of_the_documentation_is_good) {
  const std::string page = text_of(root / "docs/guides/make_a_fruit.md");
  int blocks = 0;
  std::string fruit;
  for (std::size_t at = page.find("```toml\n"); at != std::string::npos; at = page.find("```toml\n", at)) {
    at += 8;
    fruit += page.substr(at, page.find("```", at) - at);
    ++blocks;
  }
  EXPECT_GE(blocks, 4);
  EXPECT_NO_THROW(parse_template(fruit, "docs/guides/make_a_fruit.md"));
}

TEST(ReadTemplate, reads_what_is_written) {
  const Template plum = read_template(root / "tests/template/good.toml");
  EXPECT_EQ(plum.name, "plum");
  EXPECT_EQ(plum.title, "Plum");
  EXPECT_EQ(plum.parts, (std::vector<std::string>{"skin", "flesh", "stone"}));
  EXPECT_EQ(fold_count(plum), 2);
  EXPECT_DOUBLE_EQ(std::get<FoldSymmetry>(plum.symmetry).fold_angles[1], pi);

  ASSERT_EQ(plum.surfaces.size(), 2u);
  const SurfaceSketch& skin = plum.surfaces[0];
  EXPECT_EQ(skin.type, SurfaceType::around_axis);
  EXPECT_TRUE(skin.front.hidden);
  EXPECT_FALSE(skin.back.hidden);
  EXPECT_EQ(skin.back.part, 1);
  EXPECT_EQ(skin.back.color.along(1.0), *parse_color("#f0d060"));
  EXPECT_DOUBLE_EQ(skin.roundness(0.25), 0.5);
  EXPECT_EQ(skin.vertical.points.front(), glm::dvec2(0, 0));
  EXPECT_NEAR(skin.vertical.points.back().y, 0.05, 1e-9);
  EXPECT_GT(signed_area(skin.horizontal[0]), 0);

  const SurfaceSketch& stone = plum.surfaces[1];
  EXPECT_EQ(stone.type, SurfaceType::in_fold);
  EXPECT_DOUBLE_EQ(stone.blur.along(0.3), 0.0004);
  ASSERT_EQ(plum.grains.size(), 1u);
  EXPECT_EQ(plum.grains[0].surface, 1);
  EXPECT_DOUBLE_EQ(plum.grains[0].spacing.poisson_radius, 0.002);
}

TEST(ReadTemplate, nothing_bends_or_varies_unless_it_is_said) {
  const Template plum = read_template(root / "tests/template/good.toml");
  EXPECT_TRUE(plum.bend.is_straight());
  EXPECT_EQ(plum.variation.size, 0);
  EXPECT_EQ(plum.variation.profile, 0);
  EXPECT_EQ(plum.variation.bend.angle, 0);
  EXPECT_EQ(plum.variation.bend.swing, 0);
}

TEST(ReadTemplate, a_fruit_weighs_as_much_as_water_unless_it_is_said) {
  EXPECT_EQ(read_template(root / "tests/template/good.toml").density, 1000);
  EXPECT_EQ(plum_with("format = 1", "format = 1\ndensity = 840").density, 840);
  EXPECT_THROW(plum_with("format = 1", "format = 1\ndensity = 0.84"), Error) << "grams per cubic centimetre";
}

TEST(ReadTemplate, parts_have_the_fruits_density_unless_they_say_their_own) {
  EXPECT_TRUE(read_template(root / "tests/template/good.toml").densities.empty());
  const Template plum = plum_with("format = 1", "format = 1\ndensity = 1040\ndensities = { stone = 1180 }");
  EXPECT_EQ(plum.parts, (std::vector<std::string>{"skin", "flesh", "stone"}));
  EXPECT_EQ(plum.densities, (std::vector<double>{1040, 1040, 1180}));
  EXPECT_THROW(plum_with("format = 1", "format = 1\ndensities = { stome = 1180 }"), Error) << "no such part";
  EXPECT_THROW(plum_with("format = 1", "format = 1\ndensities = { stone = 0 }"), Error) << "lighter than air";
}

TEST(ReadTemplate, knives_go_through_all_parts_but_those_that_are_spared) {
  const Template as_is = read_template(root / "tests/template/good.toml");
  EXPECT_TRUE(as_is.spared.empty());
  EXPECT_TRUE(plum_and("[part.stone]\ncut = \"through\"").spared.empty());
  EXPECT_EQ(plum_with("blur = \"0.4mm\"\nfront = { part = \"flesh\", color = \"#d89a2a\" }\n"
                      "back = { part = \"stone\", color = \"#7a4a20\" }\n",
                      "front = { part = \"flesh\", color = \"#d89a2a\" }\n"
                      "back = { part = \"stone\", color = \"#7a4a20\" }\n[part.stone]\ncut = \"spare\"\n")
                .spared,
            std::vector<int>{2});
  EXPECT_THROW(plum_and("[part.stone]\ncut = \"spare\""), Error) << "its surface is blurred";
  EXPECT_THROW(plum_and("[part.flesh]\ncut = \"spare\""), Error) << "the surface around it faces air";
  EXPECT_THROW(plum_and("[part.kernel]\ncut = \"spare\""), Error) << "no such part";
  EXPECT_THROW(plum_and("[part.stone]\ncut = \"around\""), Error);
  EXPECT_EQ(plum_and("[part.flesh]\ncut = \"hold\"").held, std::vector<int>{1});
}

TEST(ReadTemplate, details_find_their_way_by_all_surfaces_but_those_that_stay_out) {
  EXPECT_TRUE(read_template(root / "tests/template/good.toml").surfaces.back().guide);
  EXPECT_FALSE(plum_with("blur = \"0.4mm\"", "guide = false").surfaces.back().guide);
}

TEST(ReadTemplate, reads_bend_and_variation) {
  const Template plum = plum_with("[symmetry]",
                                  "[bend]\nangle = 20\nswing = -12\ndirection = 90\n\n[variation]\nsize = 0.1\n"
                                  "profile = 0.06\nbend = { angle = 10, swing = 5, around = true }\n\n[symmetry]");
  EXPECT_DOUBLE_EQ(plum.bend.angle, radians(20));
  EXPECT_DOUBLE_EQ(plum.bend.swing, radians(-12));
  EXPECT_DOUBLE_EQ(plum.bend.direction, pi / 2);
  EXPECT_DOUBLE_EQ(plum.variation.size, 0.1);
  EXPECT_DOUBLE_EQ(plum.variation.profile, 0.06);
  EXPECT_DOUBLE_EQ(plum.variation.bend.angle, radians(10));
  EXPECT_DOUBLE_EQ(plum.variation.bend.swing, radians(5));
  EXPECT_TRUE(plum.variation.bend.around);
}

TEST(ReadTemplate, grains_say_where_they_grow_how_they_lie_and_what_is_in_them) {
  const Template plum = plum_with("length = \"1mm\"", R"(length = "1mm"
density = { along = [[0.0, 0.5], [1.0, 1.0]], around = 0.5 }
sector = [0.8, 0.2]
depth = [0.5, 1.0]
folds = [2]
faces = "axis"
share = 0.5
fold_share = 0.75
apart = "all"
solid = true
shape = "drop"
heading = "axis"
flat = "around"
angle = 90
tilt_jitter = 30
color_jitter = 0.05
hue_jitter = 180
looks = [{ share = 0.1, scale = 0.5, back = "#ffffff" }]
core = { scale = 0.6, shift = 0.1, front = { part = "flesh", color = "#d89a2a" }, back = { part = "stone", color = "#d89a2a" } })");
  const GrainSketch& grain = plum.grains.at(0);
  EXPECT_DOUBLE_EQ(grain.ground.density_along(0.5), 0.75);
  EXPECT_DOUBLE_EQ(grain.ground.density_around(0.5), 0.5);
  EXPECT_EQ(grain.ground.around_from, 0.8);
  EXPECT_EQ(grain.ground.depth_from, 0.5);
  EXPECT_EQ(grain.ground.folds, std::vector<int>{1});
  EXPECT_EQ(grain.ground.facing, GrainGround::Facing::towards_axis);
  EXPECT_EQ(grain.ground.share * grain.ground.fold_share, 0.375);
  EXPECT_TRUE(grain.spacing.any_facing && grain.spacing.solid);
  EXPECT_EQ(grain.form.pointedness, 1);
  EXPECT_EQ(grain.stance.heading, GrainStance::Heading::towards_axis);
  EXPECT_EQ(grain.stance.flat, GrainStance::Flat::around);
  EXPECT_DOUBLE_EQ(grain.stance.angle, pi / 2);
  EXPECT_DOUBLE_EQ(grain.hue_jitter, pi);
  ASSERT_EQ(grain.looks.size(), 1u);
  EXPECT_EQ(grain.looks[0].front.along(0), grain.front.color.along(0));
  EXPECT_EQ(grain.looks[0].back.along(0), Color(1));
  ASSERT_EQ(grain.cores.size(), 1u);
  EXPECT_EQ(grain.cores[0].form.width, 0.6);
  EXPECT_EQ(grain.cores[0].back.part, 2);
}

TEST(ReadTemplate, one_loop_is_repeated_in_every_fold) {
  const Template plum = read_template(root / "tests/template/good.toml");
  const auto& loops = plum.surfaces[1].horizontal;
  ASSERT_EQ(loops.size(), 2u);
  ASSERT_EQ(loops[0].points.size(), loops[1].points.size());
  for (std::size_t i = 0; i < loops[0].points.size(); ++i) {
    EXPECT_LT(glm::distance(loops[1].points[i], -loops[0].points[i]), 1e-12);
  }
}

TEST(ReadTemplate, a_fold_may_stay_empty) {
  const Template plum = plum_with("horizontal = \"M 2 -5 L 2 -15 L -2 -15 L -2 -5 Z\"",
                                  "horizontal = [\"\", \"M 2 5 L 2 15 L -2 15 L -2 5 Z\"]");
  EXPECT_TRUE(plum.surfaces[1].horizontal[0].points.empty());
  EXPECT_EQ(plum.surfaces[1].horizontal[1].points.size(), 4u);
}

TEST(ReadTemplate, curves_may_be_drawn_downwards_and_anywhere_in_height) {
  const Template plum = plum_with("M 0 0 C 20 0, 25 -10, 25 -25 C 25 -40, 15 -50, 0 -50",
                                  "M 0 50 C 15 50, 25 60, 25 75 C 25 90, 20 100, 0 100");
  double lowest = 1;
  for (const SurfaceSketch& surface : plum.surfaces) {
    for (const glm::dvec2& p : surface.vertical.points) lowest = std::min(lowest, p.y);
  }
  EXPECT_EQ(lowest, 0.0);
  EXPECT_LT(plum.surfaces[0].vertical.points.front().y, plum.surfaces[0].vertical.points.back().y);
}

TEST(ReadTemplate, without_a_horizontal_curve_it_is_a_circle) {
  const Template plum = plum_with("horizontal = \"M 25 0 C 25 -33, -25 -33, -25 0 C -25 33, 25 33, 25 0 Z\"\n", "");
  for (const glm::dvec2& p : plum.surfaces[0].horizontal[0].points) EXPECT_NEAR(glm::length(p), 0.025, 1e-9);
}

TEST(ReadTemplate, all_mistakes_come_at_once_and_sorted) {
  std::string text = text_of(root / "tests/template/good.toml");
  for (const auto& [from, to] : {std::pair{"#d89a2a", "orange"}, {"folds = 2", "folds = 99"}, {"\"0.4mm\"", "0.4"}}) {
    text.replace(text.find(from), std::string(from).size(), to);
  }
  try {
    parse_template(text, "plum.toml");
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    ASSERT_GE(error.diagnostics().size(), 3u);
    for (std::size_t i = 1; i < error.diagnostics().size(); ++i) {
      EXPECT_LE(error.diagnostics()[i - 1].place.line, error.diagnostics()[i].place.line);
    }
  }
}

/// Reads a text that may be broken. Expects a template or an Error with positions.
void expect_template_or_error(const std::string& text) {
  try {
    parse_template(text, "mutant.toml");
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), ExitStatus::bad_data);
    EXPECT_FALSE(error.diagnostics().empty());
    EXPECT_LE(error.diagnostics().size(), 20u);
    for (const Diagnostic& diagnostic : error.diagnostics()) EXPECT_GE(diagnostic.place.line, 1);
  }
}

TEST(ReadTemplate, survives_truncation_and_mutation) {
  const RandomStream random({2, 0}, "template mutation");
  constexpr std::string_view bytes = "[]{}=.,\"'#\n\\ 0129eE-+MCZxnai\xff\xc3\x00";
  std::uint64_t draw = 0;
  for (const fs::path& file : good_files()) {
    const std::string good = text_of(file);
    for (int n = 0; n < 60; ++n) {
      expect_template_or_error(good.substr(0, random.below(draw++, good.size())));
      std::string mutant = good;
      for (std::uint64_t k = 1 + random.below(draw++, 4); k > 0; --k) {
        const std::size_t at = random.below(draw++, mutant.size());
        const char byte = bytes[random.below(draw++, bytes.size())];
        switch (random.below(draw++, 4)) {
          case 0:
            mutant[at] = byte;
            break;
          case 1:
            mutant.insert(at, 1, byte);
            break;
          case 2:
            mutant.erase(at, 1 + random.below(draw++, 30));
            break;
          default:
            mutant.insert(at, mutant.substr(random.below(draw, mutant.size()), 40));
            break;
        }
      }
      expect_template_or_error(mutant);
    }
  }
}

}  // namespace
}  // namespace pomona
