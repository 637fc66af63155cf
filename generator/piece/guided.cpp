#include "generator/piece/guided.h"

#include <algorithm>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/diffusion/pmvc/pmvc_diffuser.h"
#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"
#include "generator/surface/skin_depth.h"

namespace pomona {

namespace {

bool any_runs(const Template& fruit, std::initializer_list<DetailRun> runs) {
  return std::any_of(fruit.details.begin(), fruit.details.end(), [&](const DetailSketch& detail) {
    return detail.face == DetailFace::cut && std::find(runs.begin(), runs.end(), detail.run) != runs.end();
  });
}

bool has_details_on(const Template& fruit, DetailFace face) {
  return std::any_of(fruit.details.begin(), fruit.details.end(),
                     [&](const DetailSketch& detail) { return detail.face == face; });
}

/// The surfaces that lie around the axis, layer around layer. What lies in folds, and grains, would turn the way
/// aside; where all surfaces are meshes, the skin alone counts.
DiffusionSurfaces layers_of(const DiffusionSurfaces& swept, const Template& fruit) {
  DiffusionSurfaces layers = swept;
  layers.triangle.clear(), layers.surface.clear(), layers.front_part.clear(), layers.back_part.clear();
  const auto add_if = [&](const auto& counts) {
    for (std::size_t t = 0; t < swept.triangle_count(); ++t) {
      if (!counts(t)) continue;
      layers.triangle.push_back(swept.triangle[t]);
      layers.surface.push_back(swept.surface[t]);
      layers.front_part.push_back(0);
      layers.back_part.push_back(0);
    }
  };
  add_if([&](std::size_t t) {
    const auto surface = static_cast<std::size_t>(swept.surface[t]);
    return surface < fruit.surfaces.size() && fruit.surfaces[surface].type == SurfaceType::around_axis;
  });
  if (layers.triangle.empty()) add_if([&](std::size_t t) { return swept.is_boundary(t); });
  return layers;
}

/// Equal positions once: what is asked of the diffuser.
struct Places {
  std::vector<glm::vec3> position;
  std::vector<std::uint32_t> of_vertex;
};

Places places_of(const std::vector<glm::vec3>& vertices) {
  const std::vector<std::uint32_t> first = weld(vertices);
  Places places{.position = {}, .of_vertex = std::vector<std::uint32_t>(vertices.size())};
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (first[v] == v) places.position.push_back(vertices[v]);
    places.of_vertex[v] =
        first[v] == v ? static_cast<std::uint32_t>(places.position.size() - 1) : places.of_vertex[first[v]];
  }
  return places;
}

std::vector<Color> diffused(DiffusionSurfaces layers, const std::vector<Color>& value, const Places& places,
                            Threads threads) {
  layers.front_color = layers.back_color = value;
  // Guides are smooth: the fewest directions do.
  return make_pmvc_diffuser({.quality = Quality::draft, .threads = threads})->diffuse(layers, places.position).color;
}

/// Unit vectors across the layers, outwards. They travel as colours, which are 0 to 1.
std::vector<glm::vec3> ways_out(const DiffusionSurfaces& layers, const Places& places, Threads threads) {
  std::vector<Color> value = vertex_normals(layers);
  for (Color& normal : value) normal = 0.5f * normal + 0.5f;
  std::vector<glm::vec3> ways;
  for (const Color& color : diffused(layers, value, places, threads)) {
    const glm::vec3 way = 2.0f * color - 1.0f;
    const float length = glm::length(way);
    ways.push_back(length > 1e-6f ? way / length : glm::vec3(0));
  }
  return ways;
}

std::vector<double> depths_of(const std::vector<glm::vec3>& points, const SkinDepth& skin, Threads threads) {
  const std::vector<glm::dvec3> places(points.begin(), points.end());
  return skin.depths(places, std::numeric_limits<double>::infinity(), threads);
}

/// Of every vertex that is a triangle's corner.
std::vector<double> corner_depths(const DiffusionSurfaces& layers, const SkinDepth& skin, Threads threads) {
  std::vector<std::uint8_t> is_corner(layers.vertex_count(), 0);
  for (const glm::uvec3& t : layers.triangle)
    for (int k = 0; k < 3; ++k) is_corner[t[k]] = 1;
  std::vector<std::size_t> corners;
  std::vector<glm::vec3> places;
  for (std::size_t v = 0; v < is_corner.size(); ++v) {
    if (is_corner[v] == 0) continue;
    corners.push_back(v);
    places.push_back(layers.position[v]);
  }
  const std::vector<double> found = depths_of(places, skin, threads);
  std::vector<double> depth(layers.vertex_count(), 0.0);
  for (std::size_t i = 0; i < corners.size(); ++i) depth[corners[i]] = found[i];
  return depth;
}

/// The depth of the layer at each place: every surface has one, its vertices' mean.
std::vector<float> layers_at(const DiffusionSurfaces& layers, const SkinDepth& skin, const Places& places,
                             Threads threads) {
  // Each surface gets its mean depth over the corners of its triangles; the greatest becomes the unit.
  const std::vector<double> depth = corner_depths(layers, skin, threads);
  std::vector<double> sum(layers.surface_names.size(), 0.0);
  std::vector<int> count(sum.size(), 0);
  for (std::size_t t = 0; t < layers.triangle_count(); ++t) {
    const auto surface = static_cast<std::size_t>(layers.surface[t]);
    for (int k = 0; k < 3; ++k) sum[surface] += depth[layers.triangle[t][k]];
    count[surface] += 3;
  }
  double deepest = 1e-9;
  for (std::size_t s = 0; s < sum.size(); ++s) deepest = std::max(deepest, sum[s] /= std::max(count[s], 1));

  // Depths are diffused as colours, in shares of the greatest.
  std::vector<Color> value(layers.vertex_count(), Color(0));
  for (std::size_t t = 0; t < layers.triangle_count(); ++t) {
    const double share = sum[static_cast<std::size_t>(layers.surface[t])] / deepest;
    for (int k = 0; k < 3; ++k) value[layers.triangle[t][k]] = Color(static_cast<float>(share));
  }
  std::vector<float> at;
  for (const Color& color : diffused(layers, value, places, threads))
    at.push_back(static_cast<float>(deepest) * color.r);
  return at;
}

}  // namespace

glm::vec4 detail_shares(const Template& fruit, DetailFace face, std::int32_t part, double depth) {
  glm::vec4 share(0);
  int next = 0;
  for (const DetailSketch& detail : fruit.details) {
    if (detail.face != face || next == most_details_of_a_face) continue;
    const bool counts = std::find(detail.parts.begin(), detail.parts.end(), part) != detail.parts.end();
    share[next++] = counts ? static_cast<float>(detail.depth(depth)) : 0.0f;
  }
  return share;
}

CrossSection guided(CrossSection section, const DiffusionSurfaces& swept, const Template& fruit, Threads threads,
                    const SkinDepth* known) {
  if (section.position.empty() || !has_details_on(fruit, DetailFace::cut)) return section;
  const Places places = places_of(section.position);
  const std::optional<SkinDepth> own = known == nullptr ? std::optional<SkinDepth>(swept) : std::nullopt;
  const SkinDepth& skin = own ? *own : *known;
  const std::vector<double> depth = depths_of(places.position, skin, threads);

  // Only what a detail asks for is diffused.
  const DiffusionSurfaces layers = layers_of(swept, fruit);
  const bool across = any_runs(fruit, {DetailRun::to_skin, DetailRun::along, DetailRun::around});
  const bool along = any_runs(fruit, {DetailRun::along, DetailRun::around});
  std::vector<glm::vec3> ways(places.position.size(), glm::vec3(0));
  std::vector<float> layer(places.position.size(), 0.0f);
  if (!layers.triangle.empty() && across) ways = ways_out(layers, places, threads);
  if (!layers.triangle.empty() && along) layer = layers_at(layers, skin, places, threads);

  section.guide.resize(section.position.size());
  for (std::size_t v = 0; v < section.guide.size(); ++v) {
    const std::uint32_t i = places.of_vertex[v];
    section.guide[v] = {ways[i] * static_cast<float>(depth[i]), layer[i],
                        detail_shares(fruit, DetailFace::cut, section.part[v], depth[i])};
  }
  return section;
}

}  // namespace pomona
