#include "render/style/tissue_light.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/vec3.hpp>

namespace pomona {

namespace {

constexpr std::pair<std::string_view, Tissue> usual[] = {
    {"gel", Tissue::gel},      {"aril", Tissue::gel},      {"skin", Tissue::skin},     {"capsule", Tissue::skin},
    {"flavedo", Tissue::skin}, {"rind", Tissue::pith},     {"pith", Tissue::pith},     {"membrane", Tissue::pith},
    {"core", Tissue::pith},    {"white", Tissue::pith},    {"fat", Tissue::pith},      {"placenta", Tissue::pith},
    {"stem", Tissue::leaf},    {"calyx", Tissue::leaf},    {"leaf", Tissue::leaf},     {"crown", Tissue::leaf},
    {"root", Tissue::leaf},    {"seed", Tissue::seed},     {"achene", Tissue::seed},   {"stone", Tissue::seed},
    {"coat", Tissue::seed},    {"kernel", Tissue::seed},   {"shell", Tissue::shell},   {"ground", Tissue::mineral},
    {"lava", Tissue::mineral}, {"magma", Tissue::mineral}, {"ash", Tissue::mineral},   {"strata", Tissue::mineral},
    {"dish", Tissue::mineral}, {"bowl", Tissue::mineral},  {"glaze", Tissue::mineral}, {"clay", Tissue::mineral}};

/// Ways in millimetres. Flesh and pith are the apple and the potato of Jensen et al. 2001 ("A practical model for
/// subsurface light transport", figure 5): 1 / sqrt(3 sigma_a (sigma_a + sigma_s')). The others are estimates by eye,
/// against photographs.
struct OfTissue {
  double weight;
  glm::dvec3 radius;
};
OfTissue of(Tissue tissue) {
  switch (tissue) {
    case Tissue::flesh:
      return {1, {6.96, 6.40, 1.90}};
    case Tissue::gel:
      return {1, {8, 6, 3}};
    case Tissue::pith:
      return {1, {14.27, 7.23, 2.04}};
    case Tissue::skin:
      return {0.5, {1.2, 0.7, 0.4}};
    case Tissue::leaf:
      return {0.5, {0.5, 0.9, 0.25}};
    case Tissue::seed:
      return {0.3, {0.5, 0.35, 0.2}};
    case Tissue::shell:
      return {0.5, {1, 0.8, 0.6}};
    case Tissue::mineral:
      break;
  }
  return {0, glm::dvec3(0)};
}

TissueLight rounded(double weight, const glm::dvec3& metres) {
  TissueLight light;
  const auto step = [](double value) { return std::round(value * 1e5) / 1e5; };
  light.radius = {step(metres.r), step(metres.g), step(metres.b)};
  const bool goes_in = light.radius != std::array<double, 3>{};
  light.weight = goes_in ? std::round(weight * 100) / 100 : 0;
  return light;
}

}  // namespace

Tissue usual_tissue(std::string_view part) {
  const auto known =
      std::find_if(std::begin(usual), std::end(usual), [&](const auto& one) { return one.first == part; });
  return known == std::end(usual) ? Tissue::flesh : known->second;
}

TissueLight tissue_light(const MaterialSketch& material, std::string_view part) {
  const OfTissue kind = of(material.tissue.value_or(usual_tissue(part)));
  if (material.subsurface) {
    const Subsurface& said = *material.subsurface;
    return rounded(said.weight, said.radius * glm::dvec3(said.tint));
  }
  if (material.translucency.depth > 0)
    return rounded(kind.weight, material.translucency.depth * glm::dvec3(material.translucency.color));
  return rounded(kind.weight, 1e-3 * kind.radius);
}

}  // namespace pomona
