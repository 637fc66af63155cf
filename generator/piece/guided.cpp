#include "generator/piece/guided.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/diffusion/pmvc/diffused_values.h"
#include "generator/mesh/weld.h"
#include "generator/surface/bodies.h"
#include "generator/surface/skin_depth.h"

namespace pomona {

namespace {

/// A detail of cut faces, and the index of its share in a guide.
struct CutDetail {
  const DetailSketch* sketch = nullptr;
  int number = 0;
};

/// Points to be measured and diffused; equal positions are stored once.
struct GuidePlaces {
  std::vector<glm::vec3> position;
  std::vector<std::uint32_t> of_vertex;
};

/// Some of the points, and the index of each among all.
struct ChosenPlaces {
  std::vector<glm::vec3> position;
  std::vector<std::size_t> place;
};

/// These places and those up to three triangles away.
std::vector<std::uint8_t> with_neighbours(std::vector<std::uint8_t> counts, const CrossSection& section,
                                          const GuidePlaces& places) {
  for (int ring = 0; ring < 3; ++ring) {
    std::vector<std::uint8_t> grown = counts;
    for (const glm::uvec3& t : section.triangle) {
      const std::uint32_t a = places.of_vertex[t.x], b = places.of_vertex[t.y], c = places.of_vertex[t.z];
      if ((counts[a] | counts[b] | counts[c]) != 0) grown[a] = grown[b] = grown[c] = 1;
    }
    counts = std::move(grown);
  }
  return counts;
}

/// The details that have an effect, in the template's order.
std::vector<CutDetail> cut_details(const Template& fruit) {
  std::vector<CutDetail> details;
  for (const DetailSketch& detail : fruit.details) {
    if (detail.face != DetailFace::cut || details.size() == static_cast<std::size_t>(max_details_of_a_face)) continue;
    details.push_back({&detail, static_cast<int>(details.size())});
  }
  return details;
}

GuidePlaces guide_places(const std::vector<glm::vec3>& vertices) {
  const std::vector<std::uint32_t> first = weld(vertices);
  GuidePlaces places{.position = {}, .of_vertex = std::vector<std::uint32_t>(vertices.size())};
  for (std::uint32_t v = 0; v < vertices.size(); ++v) {
    if (first[v] == v) places.position.push_back(vertices[v]);
    places.of_vertex[v] =
        first[v] == v ? static_cast<std::uint32_t>(places.position.size() - 1) : places.of_vertex[first[v]];
  }
  return places;
}

/// For each point: 1 where any of the details may have an effect, by the parts of the vertices there; also up to three
/// triangles away, because pictures blend the guides of a triangle's corners, and those of all triangles in a pixel.
std::vector<std::uint8_t> places_by_part(const CrossSection& section, const std::vector<CutDetail>& details,
                                         const GuidePlaces& places) {
  std::vector<std::uint8_t> counts(places.position.size(), 0);
  for (std::size_t v = 0; v < section.part.size(); ++v) {
    counts[places.of_vertex[v]] |=
        static_cast<std::uint8_t>(std::any_of(details.begin(), details.end(), [&](const CutDetail& detail) {
          const std::vector<int>& parts = detail.sketch->parts;
          return std::find(parts.begin(), parts.end(), section.part[v]) != parts.end();
        }));
  }
  return with_neighbours(std::move(counts), section, places);
}

/// The same for vertices in whose guide one of the details has a share.
std::vector<std::uint8_t> places_by_share(const CrossSection& section, const std::vector<CutDetail>& details,
                                          const GuidePlaces& places) {
  std::vector<std::uint8_t> counts(places.position.size(), 0);
  for (const CutDetail& detail : details) {
    for (std::size_t v = 0; v < section.guide.size(); ++v) {
      if (section.guide[v].share[detail.number] != 0) counts[places.of_vertex[v]] = 1;
    }
  }
  return with_neighbours(std::move(counts), section, places);
}

ChosenPlaces chosen(const GuidePlaces& places, const std::vector<std::uint8_t>& counts) {
  ChosenPlaces some;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    some.position.push_back(places.position[i]);
    some.place.push_back(i);
  }
  return some;
}

bool runs_within_layers(const CutDetail& detail) {
  return detail.sketch->run == DetailRun::along || detail.sketch->run == DetailRun::around;
}

bool runs_anywhere(const CutDetail& detail) { return detail.sketch->run != DetailRun::none; }

template <typename Question>
std::vector<CutDetail> which(const std::vector<CutDetail>& details, const Question& question) {
  std::vector<CutDetail> some;
  std::copy_if(details.begin(), details.end(), std::back_inserter(some), question);
  return some;
}

/// The surfaces around the axis, layer around layer. Surfaces in folds and grains would disturb the direction. If all
/// surfaces are meshes, only the skin counts.
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
    if (surface >= fruit.surfaces.size()) return false;
    const SurfaceSketch& sketch = fruit.surfaces[surface];
    return sketch.type == SurfaceType::around_axis && sketch.guide;
  });
  if (layers.triangle.empty()) add_if([&](std::size_t t) { return swept.is_boundary(t); });
  return layers;
}

std::vector<double> depths_of(const std::vector<glm::vec3>& points, const SkinDepth& skin, Threads threads) {
  const std::vector<glm::dvec3> places(points.begin(), points.end());
  return skin.depths(places, std::numeric_limits<double>::infinity(), threads);
}

/// Marks every vertex that is a triangle's corner.
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

/// Every surface has one depth, the mean over its vertices.
struct LayerDepths {
  std::vector<float> share;  ///< depth per vertex, as a share of the deepest; 0 at vertices without a triangle
  double deepest = 0;        ///< metres
};

LayerDepths layer_depths(const DiffusionSurfaces& layers, const SkinDepth& skin, Threads threads) {
  const std::vector<double> depth = corner_depths(layers, skin, threads);
  std::vector<double> sum(layers.surface_names.size(), 0.0);
  std::vector<int> count(sum.size(), 0);
  for (std::size_t t = 0; t < layers.triangle_count(); ++t) {
    const auto surface = static_cast<std::size_t>(layers.surface[t]);
    for (int k = 0; k < 3; ++k) sum[surface] += depth[layers.triangle[t][k]];
    count[surface] += 3;
  }
  LayerDepths found{std::vector<float>(layers.vertex_count(), 0.0f), 1e-9};
  for (std::size_t s = 0; s < sum.size(); ++s) found.deepest = std::max(found.deepest, sum[s] /= std::max(count[s], 1));
  for (std::size_t t = 0; t < layers.triangle_count(); ++t) {
    const double share = sum[static_cast<std::size_t>(layers.surface[t])] / found.deepest;
    for (int k = 0; k < 3; ++k) found.share[layers.triangle[t][k]] = static_cast<float>(share);
  }
  return found;
}

/// Per place: the outward unit vector across the layers, and the layer's depth, metres. Zero where it is not needed.
std::vector<glm::vec4> ways_and_layers(const DiffusionSurfaces& swept, const Template& fruit, const SkinDepth& skin,
                                       const GuidePlaces& places, const std::vector<std::uint8_t>& wanted,
                                       bool with_layers, Threads threads) {
  std::vector<glm::vec4> found(places.position.size(), glm::vec4(0));
  const ChosenPlaces asked = chosen(places, wanted);
  const DiffusionSurfaces layers = layers_of(swept, fruit);
  if (layers.triangle.empty() || asked.position.empty()) return found;

  // Diffused values lie between 0 and 1: normals halved, depths as shares of the deepest.
  std::vector<glm::vec4> value;
  for (const Color& normal : vertex_normals(layers)) value.emplace_back(0.5f * normal + 0.5f, 0.0f);
  LayerDepths depth;
  if (with_layers) {
    depth = layer_depths(layers, skin, threads);
    for (std::size_t v = 0; v < value.size(); ++v) value[v].w = depth.share[v];
  }
  const std::vector<glm::vec4> diffused = diffused_values(layers, value, asked.position, threads);
  for (std::size_t i = 0; i < diffused.size(); ++i) {
    const glm::vec3 way = 2.0f * glm::vec3(diffused[i]) - 1.0f;
    const float length = glm::length(way);
    found[asked.place[i]] = {length > 1e-6f ? way / length : glm::vec3(0),
                             static_cast<float>(depth.deepest) * diffused[i].w};
  }
  return found;
}

}  // namespace

glm::vec4 detail_shares(const Template& fruit, DetailFace face, std::int32_t part, double depth) {
  glm::vec4 share(0);
  int next = 0;
  for (const DetailSketch& detail : fruit.details) {
    if (detail.face != face || next == max_details_of_a_face) continue;
    const bool counts = std::find(detail.parts.begin(), detail.parts.end(), part) != detail.parts.end();
    share[next++] = counts ? static_cast<float>(detail.depth(depth)) : 0.0f;
  }
  return share;
}

CrossSection guided(CrossSection section, const DiffusionSurfaces& swept, const Template& fruit, Threads threads,
                    const SkinDepth* known) {
  const std::vector<CutDetail> details = cut_details(fruit);
  if (section.position.empty() || details.empty()) return section;
  const GuidePlaces places = guide_places(section.position);
  const std::optional<SkinDepth> own = known == nullptr ? std::optional<SkinDepth>(swept) : std::nullopt;
  const SkinDepth& skin = own ? *own : *known;

  // The depths of the places at which a detail may count, and the weight of each detail.
  const ChosenPlaces near = chosen(places, places_by_part(section, details, places));
  const std::vector<double> found = depths_of(near.position, skin, threads);
  std::vector<double> depth(places.position.size(), 0.0);
  for (std::size_t i = 0; i < found.size(); ++i) depth[near.place[i]] = found[i];
  section.guide.resize(section.position.size());
  for (std::size_t v = 0; v < section.guide.size(); ++v)
    section.guide[v].share = detail_shares(fruit, DetailFace::cut, section.part[v], depth[places.of_vertex[v]]);

  // Diffuses the direction where directed details count.
  if (std::none_of(details.begin(), details.end(), runs_anywhere)) return section;
  const bool with_layers = std::any_of(details.begin(), details.end(), runs_within_layers);
  const std::vector<glm::vec4> run =
      ways_and_layers(swept, fruit, skin, places, places_by_share(section, which(details, runs_anywhere), places),
                      with_layers, threads);
  for (std::size_t v = 0; v < section.guide.size(); ++v) {
    const std::uint32_t i = places.of_vertex[v];
    section.guide[v].to_skin = glm::vec3(run[i]) * static_cast<float>(depth[i]);
    section.guide[v].layer = run[i].w;
  }
  return section;
}

}  // namespace pomona
