#include "generator/piece/guided.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "generator/cut/section/guide_lattice.h"
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

/// Points to be measured; equal positions are stored once.
struct GuidePlaces {
  std::vector<glm::vec3> position;
  std::vector<std::uint32_t> of_vertex;
};

/// Some of the points, and the index of each among all.
struct ChosenPlaces {
  std::vector<glm::vec3> position;
  std::vector<std::size_t> place;
};

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

/// For each place: 1 where any of the details may have an effect, by the parts of the vertices there.
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
  return counts;
}

/// The triangles with a corner in whose guide one of the details has a share.
std::vector<std::array<glm::dvec3, 3>> triangles_by_share(const CrossSection& section,
                                                          const std::vector<CutDetail>& details) {
  const auto has_share = [&](std::uint32_t v) {
    return std::any_of(details.begin(), details.end(),
                       [&](const CutDetail& detail) { return section.guide[v].share[detail.number] != 0; });
  };
  std::vector<std::array<glm::dvec3, 3>> triangles;
  for (const glm::uvec3& t : section.triangle) {
    if (!has_share(t.x) && !has_share(t.y) && !has_share(t.z)) continue;
    triangles.push_back({section.position[t.x], section.position[t.y], section.position[t.z]});
  }
  return triangles;
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

/// The box of the vertices of triangles, which no cut changes.
Box<double> box_of(const DiffusionSurfaces& swept) {
  Box<double> box;
  for (const glm::uvec3& t : swept.triangle)
    for (int k = 0; k < 3; ++k) box.add(glm::dvec3(swept.position[t[k]]));
  return box;
}

/// The nodes' values. Nodes beyond the skin, at the corners of cells on it, have ways that lead back inwards, so that
/// the way is 0 on the skin between them.
std::vector<glm::vec4> node_values(const std::vector<glm::vec3>& places, double cell, const DiffusionSurfaces& swept,
                                   const Template& fruit, const SkinDepth& skin, Threads threads) {
  const std::vector<DetailGuide> guides = layer_guides(places, swept, fruit, skin, threads);
  std::vector<glm::vec4> value(guides.size());
  parallel_for(guides.size(), threads, [&](std::size_t i) {
    const bool near_skin = static_cast<double>(glm::length(guides[i].to_skin)) < 2 * cell;
    const bool outside = near_skin && skin.is_closed() && !skin.skin().contains(glm::dvec3(places[i]));
    value[i] = {outside ? -guides[i].to_skin : guides[i].to_skin, guides[i].layer};
  });
  return value;
}

/// The lattice around these triangles; null if there are none.
std::shared_ptr<const GuideLattice> lattice_around(const std::vector<std::array<glm::dvec3, 3>>& triangles,
                                                   const DiffusionSurfaces& swept, const Template& fruit,
                                                   const SkinDepth& skin, Threads threads) {
  if (triangles.empty() || swept.triangle.empty()) return nullptr;
  const LatticeFrame frame = lattice_frame(box_of(swept));
  const std::vector<glm::ivec3> nodes = nodes_around(frame, triangles);
  std::vector<glm::vec3> places;
  places.reserve(nodes.size());
  for (const glm::ivec3& node : nodes) places.emplace_back(frame.place_of(node));
  return std::make_shared<const GuideLattice>(frame, nodes,
                                              node_values(places, frame.spacing, swept, fruit, skin, threads));
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

bool has_directed_details(const Template& fruit) {
  const std::vector<CutDetail> details = cut_details(fruit);
  return std::any_of(details.begin(), details.end(), runs_anywhere);
}

std::vector<DetailGuide> layer_guides(const std::vector<glm::vec3>& points, const DiffusionSurfaces& swept,
                                      const Template& fruit, const SkinDepth& skin, Threads threads) {
  std::vector<DetailGuide> found(points.size());
  const DiffusionSurfaces layers = layers_of(swept, fruit);
  if (layers.triangle.empty() || points.empty()) return found;

  // Diffused values lie between 0 and 1: normals halved, depths as shares of the deepest.
  std::vector<glm::vec4> value;
  for (const Color& normal : vertex_normals(layers)) value.emplace_back(0.5f * normal + 0.5f, 0.0f);
  LayerDepths layer;
  const std::vector<CutDetail> details = cut_details(fruit);
  if (std::any_of(details.begin(), details.end(), runs_within_layers)) {
    layer = layer_depths(layers, skin, threads);
    for (std::size_t v = 0; v < value.size(); ++v) value[v].w = layer.share[v];
  }
  const std::vector<glm::vec4> diffused = diffused_values(layers, value, points, threads);
  const std::vector<double> depth = depths_of(points, skin, threads);
  for (std::size_t i = 0; i < diffused.size(); ++i) {
    const glm::vec3 way = 2.0f * glm::vec3(diffused[i]) - 1.0f;
    const float length = glm::length(way);
    if (length > 1e-6f) found[i].to_skin = way / length * static_cast<float>(depth[i]);
    found[i].layer = static_cast<float>(layer.deepest) * diffused[i].w;
  }
  return found;
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

  // The ways and layers, where directed details count.
  section.guide_lattice =
      lattice_around(triangles_by_share(section, which(details, runs_anywhere)), swept, fruit, skin, threads);
  if (section.guide_lattice == nullptr) return section;
  for (std::size_t v = 0; v < section.guide.size(); ++v) {
    const std::optional<glm::vec4> at = section.guide_lattice->at(glm::dvec3(section.position[v]));
    if (at) section.guide[v].to_skin = glm::vec3(*at), section.guide[v].layer = at->w;
  }
  return section;
}

}  // namespace pomona
