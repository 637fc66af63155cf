#include <map>

#include "generator/scene/solid.h"
#include "generator/surface/bodies.h"

namespace pomona {

namespace {

/// How much of what lies behind an inner surface is covered by it.
constexpr float inner_opacity = 0.55f;

/// Copies one side of a triangle, its vertices shared within the solid.
class SideBuilder {
 public:
  SideBuilder(const DiffusionSurfaces& surfaces, const std::vector<glm::vec3>& normal, Solid& solid)
      : surfaces_(surfaces), normal_(normal), solid_(solid) {}

  void add(std::size_t triangle, SideOf side) {
    glm::uvec3 corners = surfaces_.triangle[triangle];
    if (side == SideOf::back) std::swap(corners.y, corners.z);
    const std::int32_t part = side == SideOf::front ? surfaces_.front_part[triangle] : surfaces_.back_part[triangle];
    glm::uvec3 copied;
    for (int k = 0; k < 3; ++k) copied[k] = vertex(corners[k], side, part);
    solid_.triangle.push_back(copied);
    solid_.cut_face.push_back(-1);
    solid_.surface.push_back(surfaces_.surface[triangle]);
  }

 private:
  std::uint32_t vertex(std::uint32_t original, SideOf side, std::int32_t part) {
    const auto [place, added] =
        known_.try_emplace({original, side, part}, static_cast<std::uint32_t>(solid_.position.size()));
    if (added) {
      const bool front = side == SideOf::front;
      solid_.position.push_back(surfaces_.position[original]);
      solid_.normal.push_back(front ? normal_[original] : -normal_[original]);
      solid_.color.push_back(front ? surfaces_.front_color[original] : surfaces_.back_color[original]);
      solid_.part.push_back(part);
    }
    return place->second;
  }

  const DiffusionSurfaces& surfaces_;
  const std::vector<glm::vec3>& normal_;
  Solid& solid_;
  std::map<std::tuple<std::uint32_t, SideOf, std::int32_t>, std::uint32_t> known_;
};

}  // namespace

std::vector<Solid> inner_surfaces(const DiffusionSurfaces& swept, const Template& fruit, const std::string& name) {
  const std::vector<glm::vec3> normal = vertex_normals(swept);
  std::vector<Solid> all;
  for (std::size_t s = 0; s < swept.surface_names.size(); ++s) {
    Solid solid;
    solid.name = name + "." + swept.surface_names[s];
    solid.opacity = inner_opacity;
    solid.closed = true;  // both sides have triangles of their own, so neither needs to be seen from behind
    solid.part_names = swept.part_names;
    solid.noise = fruit.noise;
    solid.ink = fruit.ink;
    SideBuilder builder(swept, normal, solid);
    for (std::size_t t = 0; t < swept.triangle_count(); ++t) {
      if (swept.surface[t] != static_cast<std::int32_t>(s) || swept.is_boundary(t)) continue;
      builder.add(t, SideOf::front);
      builder.add(t, SideOf::back);
    }
    if (!solid.triangle.empty()) all.push_back(std::move(solid));
  }
  return all;
}

}  // namespace pomona
