#include "generator/piece/glass_surfaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "generator/surface/bodies.h"

namespace pomona {

namespace {

/// Copies one side of a triangle, its vertices shared within the solid.
class SideBuilder {
 public:
  SideBuilder(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normal, Solid& solid)
      : surfaces_(surfaces), normal_(normal), mesh_(solid.mesh) {}

  void add(std::size_t triangle, SideOf side) {
    glm::uvec3 corners = surfaces_.triangle[triangle];
    if (side == SideOf::back) std::swap(corners.y, corners.z);
    const std::int32_t part = side == SideOf::front ? surfaces_.front_part[triangle] : surfaces_.back_part[triangle];
    glm::uvec3 copied;
    for (int k = 0; k < 3; ++k) copied[k] = vertex(corners[k], side, part);
    mesh_.triangle.push_back(copied);
    mesh_.cut_face.push_back(-1);
    mesh_.surface.push_back(surfaces_.surface[triangle]);
  }

 private:
  std::uint32_t vertex(std::uint32_t original, SideOf side, std::int32_t part) {
    const auto [place, added] =
        known_.try_emplace({original, side, part}, static_cast<std::uint32_t>(mesh_.position.size()));
    if (added) {
      const bool front = side == SideOf::front;
      mesh_.position.push_back(surfaces_.position[original]);
      mesh_.normal.push_back(front ? normal_[original] : -normal_[original]);
      mesh_.color.push_back(front ? surfaces_.front_color[original] : surfaces_.back_color[original]);
      mesh_.part.push_back(part);
    }
    return place->second;
  }

  const DiffusionSurfaces& surfaces_;
  const std::vector<glm::vec3>& normal_;
  SolidMesh& mesh_;
  std::map<std::tuple<std::uint32_t, SideOf, std::int32_t>, std::uint32_t> known_;
};

/// The reach of each surface from the axis, as a share of the widest.
std::vector<double> reaches_of(const DiffusionSurfaces& surfaces) {
  std::vector<double> reaches(surfaces.surface_names.size(), 0.0);
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    double& reach = reaches[static_cast<std::size_t>(surfaces.surface[t])];
    for (int k = 0; k < 3; ++k) {
      const glm::dvec3 p = surfaces.position[surfaces.triangle[t][k]];
      reach = std::max(reach, std::sqrt(p.x * p.x + p.z * p.z));
    }
  }
  const double widest = reaches.empty() ? 0.0 : *std::max_element(reaches.begin(), reaches.end());
  for (double& reach : reaches) reach = widest > 0 ? reach / widest : 0;
  return reaches;
}

/// Chosen by eye: inner surfaces are denser, so that outer ones hide little.
float opacity_at(double reach) { return static_cast<float>(0.08 + 0.45 * (1 - reach)); }

constexpr float grain_opacity = 0.75f;
constexpr double grain_ink = 0.3;  // share of the fruit's ink, because grains are many and small

}  // namespace

std::vector<Solid> glass_surfaces(const GrownFruit& fruit, const Template& variant, const std::string& name) {
  const DiffusionSurfaces surfaces = joined(fruit.swept, fruit.grains);
  const std::vector<glm::vec3> normal = vertex_normals(surfaces);
  const std::vector<double> reaches = reaches_of(surfaces);
  FruitLook thinly_inked = look_of(variant, surfaces.part_names);
  const auto look = std::make_shared<const FruitLook>(thinly_inked);
  thinly_inked.ink.width *= grain_ink;
  const auto grain_look = std::make_shared<const FruitLook>(std::move(thinly_inked));
  std::vector<Solid> all(surfaces.surface_names.size());
  std::vector<SideBuilder> builders;
  for (std::size_t s = 0; s < all.size(); ++s) {
    all[s].name = name + "." + surfaces.surface_names[s];
    const bool is_grain = s >= fruit.swept.surface_names.size();
    all[s].opacity = is_grain ? grain_opacity : opacity_at(reaches[s]);
    all[s].closed = true;  // both sides have triangles of their own, so neither needs to be seen from behind
    all[s].look = is_grain ? grain_look : look;
    builders.emplace_back(surfaces, normal, all[s]);
  }
  for (std::size_t t = 0; t < surfaces.triangle_count(); ++t) {
    for (const SideOf side : {SideOf::front, SideOf::back}) {
      builders[static_cast<std::size_t>(surfaces.surface[t])].add(t, side);
    }
  }
  std::erase_if(all, [](const Solid& solid) { return solid.mesh.triangle.empty(); });
  std::stable_sort(all.begin(), all.end(), [](const Solid& a, const Solid& b) { return a.opacity > b.opacity; });
  return all;
}

}  // namespace pomona
