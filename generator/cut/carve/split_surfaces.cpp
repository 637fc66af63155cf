#include "generator/cut/carve/split_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "generator/cut/carve/facet_normals.h"
#include "generator/mesh/edge_map.h"
#include "generator/mesh/triangle_weights.h"

namespace pomona {

namespace {

using Facet = Arrangement::Facet;
using Weights = std::array<double, 3>;

glm::vec3 unit(const glm::vec3& v) {
  const float size = glm::length(v);
  return size > 0 ? v / size : v;
}

/// Splits the diffusion surfaces.
class SurfaceSplitter {
 public:
  SurfaceSplitter(CutFruit& fruit, const FruitParts& parts, const DiffusionSurfaces& surfaces, const Bodies& bodies,
                  KnifeTraces& traces)
      : mesh_(fruit.mesh),
        triangles_(fruit.surface),
        parts_(parts),
        surfaces_(surfaces),
        bodies_(bodies),
        traces_(traces) {}

  void run() {
    // Triangles that the knife passes through are replaced by their parts; whole ones only change their cell.
    std::vector<SurfaceTriangle> added;
    std::vector<std::uint8_t> gone(triangles_.size(), 0);
    for (std::uint32_t f = 0; f < parts_.surface.size(); ++f) {
      const Facet& facet = parts_.all.facet[f];
      SurfaceTriangle& whole = triangles_[parts_.surface[f]];
      if (facet.is_whole()) {
        if (parts_.winding[f][0] > 0) whole.cell += parts_.stride;
        continue;
      }
      find_vertices(whole, facet);
      take_segments(whole, facet);
      for (std::size_t k = 0; k < facet.mesh.triangle.size(); ++k) {
        const PlaceTriangle& t = facet.mesh.triangle[k];
        const std::uint32_t inside = parts_.winding[f][k] > 0 ? parts_.stride : 0;
        added.push_back({{vertex_[t[0]], vertex_[t[1]], vertex_[t[2]]}, whole.source, whole.cell + inside});
      }
      gone[parts_.surface[f]] = 1;
    }

    // Put the parts after the triangles that are left.
    std::size_t kept = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!gone[t]) triangles_[kept++] = triangles_[t];
    }
    triangles_.resize(kept);
    triangles_.insert(triangles_.end(), added.begin(), added.end());
  }

 private:
  /// The vertex at each place of a triangle.
  void find_vertices(const SurfaceTriangle& whole, const Facet& facet) {
    vertex_.clear();
    for (std::size_t i = 0; i < 3; ++i) vertex_[facet.corner[i]] = whole.vertex[i];
    for (std::size_t i = 0; i < 3; ++i) {
      for (const std::uint32_t place : facet.mesh.chain[i]) {
        if (!vertex_.contains(place))
          vertex_[place] = vertex_between(whole.vertex[i], whole.vertex[(i + 1) % 3], place);
      }
    }
    for (const PlaceTriangle& t : facet.mesh.triangle) {
      for (const std::uint32_t place : t) {
        if (!vertex_.contains(place)) vertex_[place] = vertex_within(whole.vertex, place);
      }
    }
  }

  /// The vertex at a place on an edge: the same for all triangles there.
  std::uint32_t vertex_between(std::uint32_t a, std::uint32_t b, std::uint32_t place) {
    if (mesh_.point_of[a] > mesh_.point_of[b]) std::swap(a, b);
    const auto [entry, is_new] = made_.try_emplace({a, b, place}, static_cast<std::uint32_t>(mesh_.point_of.size()));
    if (!is_new) return entry->second;
    const double t = share_between(mesh_.place_of(a), mesh_.place_of(b), mesh_.point[place]);
    return add({a, b, b}, {1 - t, t, 0}, place);
  }

  std::uint32_t vertex_within(const std::array<std::uint32_t, 3>& v, std::uint32_t place) {
    return add(v, weights_in({mesh_.place_of(v[0]), mesh_.place_of(v[1]), mesh_.place_of(v[2])}, mesh_.point[place]),
               place);
  }

  std::uint32_t add(const std::array<std::uint32_t, 3>& v, const Weights& weights, std::uint32_t place) {
    Color front(0), back(0);
    glm::vec3 normal(0);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto w = static_cast<float>(weights[i]);
      front += w * mesh_.front_color[v[i]];
      back += w * mesh_.back_color[v[i]];
      normal += w * mesh_.normal[v[i]];
    }
    return mesh_.add_vertex(place, front, back, unit(normal));
  }

  /// Segments are directed by the input's front; triangles that face air may have been turned over since.
  void take_segments(const SurfaceTriangle& whole, const Facet& facet) {
    const bool is_skin = surfaces_.is_boundary(whole.source);
    const bool turned = is_skin && surfaces_.is_hidden(whole.source, SideOf::back);
    for (std::size_t i = 3; i < facet.mesh.chain.size(); ++i) {
      const std::vector<std::uint32_t>& chain = facet.mesh.chain[i];
      for (std::size_t k = 1; k < chain.size(); ++k) {
        std::uint32_t from = chain[k - 1], to = chain[k];
        if (is_skin) traces_.edges.push_back({from, to, boundary_of(whole, bodies_)});
        if (turned) std::swap(from, to);
        traces_.segments.push_back({from, to, vertex_[from], vertex_[to], whole.source});
      }
    }
  }

  SplitMesh& mesh_;
  std::vector<SurfaceTriangle>& triangles_;
  const FruitParts& parts_;
  const DiffusionSurfaces& surfaces_;
  const Bodies& bodies_;
  KnifeTraces& traces_;
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> made_;
  std::unordered_map<std::uint32_t, std::uint32_t> vertex_;  // of the triangle at work, by place
};

/// Splits the faces that earlier knives have cut.
class SectionSplitter {
 public:
  SectionSplitter(CutFruit& fruit, const FruitParts& parts, KnifeTraces& traces)
      : point_(fruit.mesh.point), section_(fruit.section), mesh_(fruit.section.mesh), parts_(parts), traces_(traces) {}

  void run() {
    find_surface_edges();
    const std::size_t first = parts_.surface.size();
    std::vector<std::uint8_t> gone(mesh_.triangle.size(), 0);
    for (std::size_t i = 0; i < parts_.cap.size(); ++i) {
      const Facet& facet = parts_.all.facet[first + i];
      const std::vector<int>& winding = parts_.winding[first + i];
      const std::uint32_t t = parts_.cap[i];
      if (facet.is_whole()) {
        if (winding[0] > 0) enter(section_.cap[t]);
        continue;
      }
      find_vertices(t, facet);
      take_creases(section_.cap[t], facet);
      for (std::size_t k = 0; k < facet.mesh.triangle.size(); ++k)
        add_part(t, facet, facet.mesh.triangle[k], winding[k]);
      gone[t] = 1;
    }
    section_ = without(std::move(section_), gone);
    split_segments();
  }

 private:
  void enter(Cap& cap) const {
    for (std::uint32_t& cell : cap.closing.cell) cell += parts_.stride;
  }

  /// Finds the edges that follow a surface, and its colours there.
  void find_surface_edges() {
    place_.assign(mesh_.position.size(), 0);
    for (std::size_t t = 0; t < mesh_.triangle.size(); ++t) {
      for (int i = 0; i < 3; ++i) place_[mesh_.triangle[t][i]] = section_.cap[t].point[static_cast<std::size_t>(i)];
    }
    for (const SectionSegment& s : mesh_.segments) on_surface_.insert({place_[s.vertex[0]], place_[s.vertex[1]]});
  }

  void find_vertices(std::uint32_t triangle, const Facet& facet) {
    vertex_.clear();
    const glm::uvec3 v = mesh_.triangle[triangle];
    for (int i = 0; i < 3; ++i) vertex_[facet.corner[static_cast<std::size_t>(i)]] = v[i];
    for (std::size_t i = 0; i < 3; ++i)
      take_edge(v[static_cast<int>(i)], v[static_cast<int>((i + 1) % 3)], facet.mesh.chain[i]);
    for (const PlaceTriangle& t : facet.mesh.triangle) {
      for (const std::uint32_t place : t) {
        if (!vertex_.contains(place)) vertex_[place] = shared_vertex(place, mesh_.part[v.x]);
      }
    }
    for (std::size_t i = 3; i < facet.mesh.chain.size(); ++i) {
      for (const std::uint32_t place : facet.mesh.chain[i]) share(place);
    }
  }

  /// Shares vertices of the section that lie on the knife's surface.
  void share(std::uint32_t place) {
    const std::uint32_t v = vertex_.at(place);
    if (mesh_.interior[v]) traces_.shared.try_emplace(place, v);
  }

  void take_edge(std::uint32_t v, std::uint32_t w, const std::vector<std::uint32_t>& chain) {
    const bool colored = on_surface_.contains({chain.front(), chain.back()});
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) {
      vertex_[chain[k]] = colored ? colored_vertex(v, w, chain[k]) : shared_vertex(chain[k], mesh_.part[v]);
    }
    if (chain.size() < 3) return;
    std::vector<std::uint32_t>& inner = inner_[{v, w}];
    inner.clear();
    for (std::size_t k = 1; k + 1 < chain.size(); ++k) inner.push_back(vertex_[chain[k]]);
    if (v > w) std::reverse(inner.begin(), inner.end());
  }

  std::uint32_t colored_vertex(std::uint32_t v, std::uint32_t w, std::uint32_t place) {
    if (v > w) std::swap(v, w);
    const auto [entry, is_new] = made_.try_emplace({v, w, place}, static_cast<std::uint32_t>(mesh_.position.size()));
    if (!is_new) return entry->second;
    const auto share = static_cast<float>(share_between(point_[place_[v]], point_[place_[w]], point_[place]));
    return add(place, glm::mix(mesh_.color[v], mesh_.color[w], share), 0, mesh_.part[v]);
  }

  std::uint32_t shared_vertex(std::uint32_t place, std::int32_t part) {
    const auto [entry, is_new] = shared_.try_emplace(place, static_cast<std::uint32_t>(mesh_.position.size()));
    return is_new ? add(place, Color(0), 1, part) : entry->second;
  }

  std::uint32_t add(std::uint32_t place, const Color& color, std::uint8_t interior, std::int32_t part) {
    mesh_.position.emplace_back(point_[place]);
    mesh_.color.push_back(color);
    mesh_.interior.push_back(interior);
    mesh_.part.push_back(part);
    return static_cast<std::uint32_t>(mesh_.position.size() - 1);
  }

  void take_creases(const Cap& cap, const Facet& facet) {
    for (std::size_t i = 3; i < facet.mesh.chain.size(); ++i) {
      const std::vector<std::uint32_t>& chain = facet.mesh.chain[i];
      for (std::size_t k = 1; k < chain.size(); ++k) {
        traces_.edges.push_back({chain[k - 1], chain[k], boundary_of(cap)});
      }
    }
  }

  void add_part(std::uint32_t triangle, const Facet& facet, const PlaceTriangle& t, int winding) {
    mesh_.triangle.emplace_back(vertex_.at(t[0]), vertex_.at(t[1]), vertex_.at(t[2]));
    mesh_.cut.push_back(mesh_.cut[triangle]);
    if (!mesh_.normal.empty()) mesh_.normal.push_back(normals_at(mesh_.normal[triangle], facet, t));
    Cap cap = section_.cap[triangle];
    cap.point = t;
    if (winding > 0) enter(cap);
    section_.cap.push_back(std::move(cap));
  }

  std::array<glm::vec3, 3> normals_at(const std::array<glm::vec3, 3>& normal, const Facet& facet,
                                      const PlaceTriangle& t) const {
    if (normal[0] == normal[1] && normal[1] == normal[2]) return normal;
    const std::array<glm::dvec3, 3> at_corners{normal[0], normal[1], normal[2]};
    std::array<glm::vec3, 3> at{};
    for (std::size_t i = 0; i < 3; ++i) at[i] = normal_at(t[i], facet, at_corners, point_);
    return at;
  }

  void split_segments() {
    std::vector<SectionSegment> all;
    for (const SectionSegment& s : mesh_.segments) {
      std::vector<std::uint32_t> way{s.vertex[0]};
      if (const std::vector<std::uint32_t>* inner = inner_.find({s.vertex[0], s.vertex[1]}))
        way.insert(way.end(), inner->begin(), inner->end());
      if (s.vertex[0] > s.vertex[1]) std::reverse(way.begin() + 1, way.end());
      way.push_back(s.vertex[1]);
      for (std::size_t i = 1; i < way.size(); ++i) all.push_back({{way[i - 1], way[i]}, s.surface, s.boundary});
    }
    mesh_.segments = std::move(all);
  }

  const std::vector<glm::dvec3>& point_;
  Section& section_;
  CrossSection& mesh_;
  const FruitParts& parts_;
  KnifeTraces& traces_;
  std::vector<std::uint32_t> place_;  // per vertex of the section as it was
  EdgeSet on_surface_;
  EdgeMap<std::vector<std::uint32_t>> inner_;  // new vertices between two old ones, from the lower one on
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> made_;
  std::map<std::uint32_t, std::uint32_t> shared_;
  std::unordered_map<std::uint32_t, std::uint32_t> vertex_;  // of the triangle at work, by place
};

}  // namespace

std::vector<CellBoundary> boundary_of(const SurfaceTriangle& skin, const Bodies& bodies) {
  return {{skin.cell, bodies.of_triangle[skin.source], 1}};
}

/// The boundary of a cap. Faces look to their positive side.
std::vector<CellBoundary> boundary_of(const Cap& cap) {
  std::vector<CellBoundary> all;
  for (const BodyWinding& w : cap.closing.inside) {
    all.push_back({cap.closing.cell[0], w.body, w.winding});
    all.push_back({cap.closing.cell[1], w.body, -w.winding});
  }
  return all;
}

SplitFruit split_surfaces(CutFruit fruit, const FruitParts& parts, const DiffusionSurfaces& surfaces,
                          const Bodies& bodies) {
  SplitFruit split{std::move(fruit), {}};
  SurfaceSplitter(split.fruit, parts, surfaces, bodies, split.traces).run();
  SectionSplitter(split.fruit, parts, split.traces).run();
  split.traces.segments = without_mere_touches(std::move(split.traces.segments), surfaces, bodies);
  return split;
}

}  // namespace pomona
