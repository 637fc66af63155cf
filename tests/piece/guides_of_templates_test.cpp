// The promise of details on shipped templates: two cuts made apart agree to the bit where they meet, in the guides of
// texture and in its colours, drawn or by example.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/cut/section/guide_lattice.h"
#include "generator/knife/parse_knife.h"
#include "generator/piece/guided.h"
#include "generator/template/read/read_template.h"
#include "render/style/look.h"

namespace pomona {
namespace {

/// All details on all parts, so that every place of a cut has a guide.
Template counting_everywhere(Template fruit) {
  for (DetailSketch& detail : fruit.details) {
    detail.parts = {0};
    detail.depth = Ramp<double>::constant(1);
  }
  return fruit;
}

CrossSection guided_section(const GrownFruit& grown, const Template& fruit, const std::string& knife) {
  const std::vector<Knife> knives{parse_knife(knife)};
  CrossSection section = cut(grown.swept, knives).section;
  section.part.assign(section.position.size(), 0);
  return guided(std::move(section), grown.swept, fruit, {}, grown.skin.get());
}

Color color_at(const Look& look, const glm::dvec3& place, const glm::vec4& way_layer) {
  return look(Color(0.4f, 0.5f, 0.2f),
              {.position = place, .footprint = 1e-4, .guide = {glm::vec3(way_layer), way_layer.w, glm::vec4(1)}});
}

class GuidesOfTemplates : public testing::TestWithParam<const char*> {};

TEST_P(GuidesOfTemplates, AgreeToTheBitWhereTwoCutsMeet) {
  const std::filesystem::path templates = std::filesystem::path(POMONA_SOURCE_DIR) / "templates";
  const Template fruit = counting_everywhere(read_template(templates / (std::string(GetParam()) + ".toml")));
  const GrownFruit grown = grow(fruit, {0, 0}, {.as_drawn = true});
  ASSERT_TRUE(has_directed_details(fruit));
  const CrossSection half = guided_section(grown, fruit, "half"), across = guided_section(grown, fruit, "across");
  ASSERT_NE(half.guide_lattice, nullptr);
  ASSERT_NE(across.guide_lattice, nullptr);

  // Along the line where both planes meet.
  const Look look(fruit.noise, fruit.details);
  const glm::dvec3 middle = across.faces.front().origin;
  const Box<double> box = bounds_of(grown.swept);
  int met = 0;
  for (int i = 0; i <= 1000; ++i) {
    const glm::dvec3 place(box.low.x + box.size().x * i / 1000, middle.y, 0);
    const auto in_half = half.guide_lattice->at(place), in_across = across.guide_lattice->at(place);
    if (!in_half || !in_across) continue;
    ++met;
    EXPECT_EQ(*in_half, *in_across) << place.x;
    EXPECT_EQ(color_at(look, place, *in_half), color_at(look, place, *in_across)) << place.x;
  }
  EXPECT_GT(met, 100);
}

INSTANTIATE_TEST_SUITE_P(Shipped, GuidesOfTemplates,
                         testing::Values("kiwi", "lemon", "beetroot", "onion", "tomato", "watermelon"));

}  // namespace
}  // namespace pomona
