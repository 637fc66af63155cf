#include "bench/fruits.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "generator/base/error.h"
#include "generator/knife/parse_knife.h"
#include "generator/template/read/read_template.h"

namespace pomona::bench {

namespace {

const std::filesystem::path template_folder = std::filesystem::path(POMONA_SOURCE_DIR) / "templates";

}  // namespace

std::vector<std::string> fruit_names(const std::vector<std::string>& wanted) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(template_folder)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  if (wanted.empty()) return names;
  for (const std::string& name : wanted) {
    if (std::filesystem::exists(template_path(name))) continue;
    throw Error(ExitStatus::input_missing, "there is no template \"" + name + "\"");
  }
  return wanted;
}

std::filesystem::path template_path(const std::string& name) { return template_folder / (name + ".toml"); }

BenchFruit grow_fruit(const std::string& name, double detail) {
  BenchFruit fruit;
  fruit.name = name;
  fruit.drawn = read_template(template_path(name));
  GrowOptions how;
  how.as_drawn = true;
  how.detail = detail;
  fruit.grown = grow(fruit.drawn, {}, how);
  return fruit;
}

double detail_for(const std::string& name, int triangles) {
  double low = 0.1, high = 4;
  for (int i = 0; i < 8; ++i) {
    const double detail = std::sqrt(low * high);
    const std::size_t count = grow_fruit(name, detail).grown.sheets.triangle_count();
    (count > static_cast<std::size_t>(triangles) ? high : low) = detail;
  }
  return std::sqrt(low * high);
}

std::vector<BenchCut> standard_cuts(const DiffusionSurfaces& surfaces) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, 1, 0.2));
  const CuttingPlane plane{normal, glm::dot(normal, bounds_of(surfaces).center())};
  const Knife slanted{PlaneCut(PlaneKnife{plane}), "slanted"};
  return {{"half", parse_knife("half")}, {"across", parse_knife("across")}, {"slanted", slanted}};
}

std::vector<glm::vec3> interior_positions(const CrossSection& section) {
  std::vector<glm::vec3> positions;
  for (std::size_t v = 0; v < section.position.size(); ++v) {
    if (section.interior[v]) positions.push_back(section.position[v]);
  }
  return positions;
}

}  // namespace pomona::bench
