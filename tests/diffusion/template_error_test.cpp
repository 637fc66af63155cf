// Draft and final keep the stated errors on real fruits: a sample of what bench/diffusion_errors measures.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/base/color.h"
#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/template/read/read_template.h"
#include "tests/diffusion/fields.h"

namespace pomona {
namespace {

/// About `max` interior vertices of a section, evenly picked.
std::vector<glm::vec3> some_interior(const CrossSection& section, std::size_t max) {
  std::vector<glm::vec3> interior, some;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (section.interior[v]) interior.push_back(section.position[v]);
  }
  for (std::size_t i = 0; i < max && i < interior.size(); ++i) {
    some.push_back(interior[i * interior.size() / std::min(max, interior.size())]);
  }
  return some;
}

/// In sRGB, where errors in the dark count for more.
std::vector<Color> encoded(std::vector<Color> colors) {
  for (Color& color : colors) {
    for (int k = 0; k < 3; ++k) color[k] = static_cast<float>(srgb_from_linear(static_cast<double>(color[k])));
  }
  return colors;
}

class TemplateError : public testing::TestWithParam<const char*> {};

TEST_P(TemplateError, IsWhatDraftAndFinalPromise) {
  GrowOptions how;
  how.as_drawn = true;
  const std::string path = std::string(POMONA_SOURCE_DIR "/templates/") + GetParam() + ".toml";
  const DiffusionSurfaces surfaces = grow(read_template(path), {}, how).sheets;
  CuttingPlane plane{glm::normalize(glm::dvec3(0.3, 1, 0.2))};
  plane.offset = glm::dot(plane.normal, bounds_of(surfaces).center());
  const Knife slanted{PlaneCut(PlaneKnife{plane}), "slanted"};
  for (const Knife& knife : {parse_knife("half"), slanted}) {
    SCOPED_TRACE(knife.text);
    const std::vector<glm::vec3> points = some_interior(cut(surfaces, {&knife, 1}).section, 60);
    ASSERT_FALSE(points.empty());
    const auto diffused = [&](Quality quality) {
      return make_pmvc_diffuser({quality, {}})->diffuse(surfaces, points).color;
    };
    const std::vector<Color> truth = diffused(Quality::reference);
    const std::vector<Color> draft = diffused(Quality::draft), fine = diffused(Quality::final);
    EXPECT_LE(fields::errors_of(draft, truth).rms, 1);
    EXPECT_LE(fields::errors_of(encoded(draft), encoded(truth)).rms, 1);
    for (const fields::Errors& errors :
         {fields::errors_of(fine, truth), fields::errors_of(encoded(fine), encoded(truth))}) {
      EXPECT_LE(errors.rms, 0.4);
      EXPECT_LE(errors.p95, 1);
      EXPECT_LE(errors.max, 2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Fruits, TemplateError, testing::Values("strawberry", "tomato"),
                         [](const auto& fruit) { return std::string(fruit.param); });

}  // namespace
}  // namespace pomona
