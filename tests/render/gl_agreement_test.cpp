// Diffusion by OpenGL and by the CPU gives the same picture of every template.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "generator/compose/grow.h"
#include "generator/cut/cut.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/knife/parse_knife.h"
#include "generator/template/read/read_template.h"
#include "render/diffusion/gl_diffuser.h"
#include "tests/diffusion/fields.h"

namespace pomona {
namespace {

const std::filesystem::path template_folder = std::filesystem::path(POMONA_SOURCE_DIR) / "templates";

std::vector<std::string> template_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(template_folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Coarse cuts: a few points are enough, and OpenGL is slow in software (bench/gl_diffusion uses all points). Leaves
/// are so thin that only a finer cut has points within them.
std::vector<glm::vec3> points_on_cut(const DiffusionSurfaces& surfaces, const Knife& knife, std::size_t count,
                                     double finest = 1.0 / 150) {
  const CutOptions coarse{.coarsest = 1.0 / 40, .finest = finest, .contrast = 0.02};
  const CrossSection section = cut(surfaces, {&knife, 1}, coarse).section;
  std::vector<glm::vec3> points;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (section.interior[v]) points.push_back(section.position[v]);
  }
  std::vector<glm::vec3> some;
  const std::size_t step = std::max<std::size_t>(1, points.size() / count);
  for (std::size_t i = 0; i < points.size(); i += step) some.push_back(points[i]);
  return some;
}

/// Half, across, and a slanted plane through the middle.
std::vector<Knife> knives_for(const DiffusionSurfaces& surfaces) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 1, 0.2));
  const Knife slanted{PlaneCut(PlaneKnife{{normal, glm::dot(normal, bounds_of(surfaces).center())}})};
  return {parse_knife("half"), parse_knife("across"), slanted};
}

class EveryTemplate : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryTemplate, HasTheColoursOfTheCpu) {
  const Template fruit = read_template(template_folder / (GetParam() + ".toml"));
  GrowOptions as_drawn;
  as_drawn.as_drawn = true;
  as_drawn.detail = 0.3;
  const DiffusionSurfaces sheets = grow(fruit, {}, as_drawn).sheets;
  std::vector<std::vector<glm::vec3>> points;
  for (const Knife& knife : knives_for(sheets)) points.push_back(points_on_cut(sheets, knife, 12));
  if (std::all_of(points.begin(), points.end(), [](const auto& on_cut) { return on_cut.empty(); }))
    points = {points_on_cut(sheets, parse_knife("across"), 12, 1.0 / 600)};
  std::vector<DiffusionTask> sections;
  for (const std::vector<glm::vec3>& on_cut : points) {
    if (!on_cut.empty()) sections.push_back({&sheets, on_cut});  // a plain section only has vertices on its lines
  }
  ASSERT_FALSE(sections.empty());

  static const auto opened_once = make_gl_diffuser();
  const std::vector<DiffusedColors> by_gl = opened_once->diffuse_all(sections);
  const std::vector<DiffusedColors> by_cpu = make_pmvc_diffuser({Quality::reference, {}})->diffuse_all(sections);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const fields::Errors difference = fields::errors_of(by_gl[i].color, by_cpu[i].color);
    EXPECT_LE(difference.rms, 1) << "cut " << i;
    EXPECT_LE(difference.max, 3) << "cut " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Templates, EveryTemplate, ::testing::ValuesIn(template_names()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace pomona
