#include "render/texture/shine.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "generator/mesh/box.h"
#include "generator/mesh/weld.h"
#include "render/style/pbr_roughness.h"

namespace pomona {

namespace {

/// The share of the solid's diagonal over which a film of juice thins out.
constexpr double thinning = 0.02;

/// Whether the eye sees equal colours, as at a surface between parts with equal sides.
constexpr float alike = 0.02f;

bool look_alike(const Color& a, const Color& b) {
  return glm::all(glm::lessThan(glm::abs(glm::vec3(a) - glm::vec3(b)), glm::vec3(alike)));
}

/// For each vertex, the first one at the same place with the same colour.
std::vector<std::uint32_t> joints(const Solid& solid) {
  const std::vector<std::uint32_t> first = weld(solid.mesh.position);
  std::vector<std::vector<std::uint32_t>> firsts(first.size());  // vertices of a place, one of each colour, by its
                                                                 // first vertex
  std::vector<std::uint32_t> joint;
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    std::vector<std::uint32_t>& known = firsts[first[v]];
    const auto like = std::find_if(known.begin(), known.end(), [&](std::uint32_t k) {
      return look_alike(solid.mesh.color[k], solid.mesh.color[v]);
    });
    joint.push_back(like == known.end() ? v : *like);
    if (like == known.end()) known.push_back(v);
  }
  return joint;
}

}  // namespace

Shine::Shine(const Solid& solid) : mesh_(solid.mesh), joint_(joints(solid)), vertex_(solid.mesh.position.size()) {
  for (std::size_t part = 0; part < std::max<std::size_t>(solid.look->part_names.size(), 1); ++part) {
    const MaterialSketch material = material_of(solid, static_cast<std::int32_t>(part));
    if (solid.look->materials.empty()) {
      part_.push_back({pbr_dull, pbr_dull, 0});
    } else {
      part_.push_back({pbr_roughness(material, false), pbr_roughness(material, true), pbr_film(material)});
    }
  }
  part_.push_back({pbr_dull, pbr_dull, 0});  // of triangles without a part

  // Collects the triangles around each vertex.
  for (std::uint32_t t = 0; t < solid.mesh.triangle.size(); ++t) {
    if (solid.mesh.cut_face[t] < 0) continue;
    for (int i = 0; i < 3; ++i) {
      AtVertex& at = vertex_[joint_[solid.mesh.triangle[t][i]]];
      at.roughness += roughness_of(t);
      at.driest = std::min(at.driest, of_part(t).film);
      at.wettest = std::max(at.wettest, of_part(t).film);
      ++at.count;
    }
  }
  for (AtVertex& at : vertex_)
    if (at.wettest > 0) at.share = at.driest / at.wettest;
  thin_out();
}

/// Distances from the border with a drier part, along the edges of the wet part's triangles [Dijkstra 1959].
void Shine::thin_out() {
  Box<double> box;
  for (const glm::vec3& p : mesh_.position) box.add(glm::dvec3(p));
  const double width = thinning * glm::length(box.size());
  if (!(width > 0)) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (std::uint32_t t = 0; t < mesh_.triangle.size(); ++t) {
    if (mesh_.cut_face[t] < 0 || !(of_part(t).film > 0)) continue;
    for (int i = 0; i < 3; ++i) {
      edges.emplace_back(joint_[mesh_.triangle[t][i]], joint_[mesh_.triangle[t][(i + 1) % 3]]);
      edges.emplace_back(edges.back().second, edges.back().first);
    }
  }
  std::sort(edges.begin(), edges.end());

  // The nearest first; equally near ones by index.
  std::vector<double> distance(vertex_.size(), width), border(vertex_.size(), 1);
  std::set<std::pair<double, std::uint32_t>> next;
  for (std::uint32_t v = 0; v < vertex_.size(); ++v) {
    if (!(vertex_[v].share < 1)) continue;
    border[v] = vertex_[v].share;
    next.emplace(distance[v] = 0, v);
  }
  while (!next.empty()) {
    const auto [way, from] = *next.begin();
    next.erase(next.begin());
    const double far = way / width;
    vertex_[from].share = glm::mix(border[from], 1.0, far * far * (3 - 2 * far));
    for (auto edge = std::lower_bound(edges.begin(), edges.end(), std::pair(from, 0u));
         edge != edges.end() && edge->first == from; ++edge) {
      const std::uint32_t to = edge->second;
      const double there = way + glm::distance(glm::dvec3(mesh_.position[from]), glm::dvec3(mesh_.position[to]));
      if (!(there < distance[to])) continue;
      next.erase({distance[to], to});
      next.emplace(distance[to] = there, to);
      border[to] = border[from];
    }
  }
}

PlaceShine Shine::at(std::uint32_t triangle, const glm::dvec3& weight) const {
  const double own = roughness_of(triangle);
  if (mesh_.cut_face[triangle] < 0) return {own, 1};
  PlaceShine sum{own, 0};
  const double film = of_part(triangle).film;
  for (int i = 0; i < 3; ++i) {
    const AtVertex& at = around(mesh_.triangle[triangle][i]);
    sum.roughness += weight[i] * (at.roughness / at.count - own);
    // A drier part beside a wetter one ends where the film of that one ends.
    sum.film += weight[i] * (film < at.wettest ? at.driest / std::max(film, 1e-9) : at.share);
  }
  return sum;
}

const Shine::OfPart& Shine::of_part(std::uint32_t triangle) const {
  const std::int32_t part = mesh_.part[mesh_.triangle[triangle].x];
  const auto number = static_cast<std::size_t>(std::max(part, 0));
  return number < part_.size() ? part_[number] : part_.back();
}

double Shine::roughness_of(std::uint32_t triangle) const {
  const OfPart& part = of_part(triangle);
  return mesh_.cut_face[triangle] < 0 ? part.skin_roughness : part.cut_roughness;
}

}  // namespace pomona
