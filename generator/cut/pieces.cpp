#include "generator/cut/pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/parallel.h"
#include "generator/cut/edge_balance.h"
#include "generator/cut/piece_groups.h"
#include "generator/cut/stray_bits.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/signed_volume.h"

namespace pomona {

namespace {

class PairNumbers {
 public:
  /// \param firsts all first indices are below this.
  explicit PairNumbers(std::size_t firsts) : latest_(firsts, none) {}

  /// The pair's number, and whether the pair is new. A new pair gets `number`.
  std::pair<std::uint32_t, bool> try_emplace(std::uint32_t first, std::uint32_t second, std::uint32_t number) {
    for (std::uint32_t e = latest_[first]; e != none; e = entry_[e].before) {
      if (entry_[e].second == second) return {entry_[e].number, false};
    }
    entry_.push_back({second, number, latest_[first]});
    latest_[first] = static_cast<std::uint32_t>(entry_.size() - 1);
    return {number, true};
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  struct Entry {
    std::uint32_t second = 0, number = 0;
    std::uint32_t before = none;  ///< the entry before it with the same first index
  };
  std::vector<std::uint32_t> latest_;  // entry, per first index
  std::vector<Entry> entry_;
};

constexpr std::uint32_t unset = 0xffffffffu;

/// Sorted.
std::vector<std::int32_t> each_once(std::vector<std::int32_t> numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

class PieceBuilder {
 public:
  PieceBuilder(const SparedFruit& cut, const DiffusionSurfaces& surfaces, const CutOptions& options)
      : mesh_(cut.fruit.mesh),
        section_(cut.fruit.section),
        uncut_(cut.uncut),
        surfaces_(surfaces),
        options_(options),
        on_wall_(cut.fruit.mesh.point.size(), 0),
        nodes_(cut.fruit.mesh.point.size()) {
    for (const SurfaceTriangle& t : cut.fruit.surface) {
      if (!surfaces.is_boundary(t.source)) continue;
      skin_.push_back({t, surfaces.is_hidden(t.source, SideOf::front) ? SideOf::front : SideOf::back});
    }
    first_wall_ = skin_.size();
    for (const SparedWall& wall : cut.walls) {
      skin_.push_back({wall.triangle, wall.shows});
      for (const std::uint32_t v : wall.triangle.vertex) on_wall_[mesh_.point_of[v]] = 1;
    }
    find_shared_points();
  }

  std::vector<CutPiece> build() {
    connect();
    number_components();
    std::vector<CutPiece> pieces(component_.size());
    fill_skins(pieces);
    fill_caps(pieces);
    edges_.resize(pieces.size());
    parallel_for(pieces.size(), options_.threads, [&](std::size_t i) { edges_[i] = measured(pieces[i]); });
    return ordered(grouped(std::move(pieces)));
  }

 private:
  struct Component {
    std::uint32_t cell = 0;
  };

  /// Finds points where bodies in different cells touch: a stem that a corer pushes aside, and the flesh below it.
  void find_shared_points() {
    std::vector<std::uint32_t> cell(mesh_.point.size(), unset);
    for (const SparedWall& wall : skin_) {
      for (const std::uint32_t v : wall.triangle.vertex) {
        std::uint32_t& known = cell[mesh_.point_of[v]];
        if (known != unset && known != wall.triangle.cell) on_wall_[mesh_.point_of[v]] = 1;
        known = wall.triangle.cell;
      }
    }
  }

  glm::vec3 position(std::uint32_t point) const { return glm::vec3(mesh_.point[point]); }

  bool is_uncut(std::size_t cap) const { return cap < uncut_.size() && uncut_[cap] != 0; }

  /// The node of a point in a cell. A point on planes, on the wall of a spared part or where cells touch has one node
  /// in each cell; any other lies in one cell.
  std::uint32_t node(std::uint32_t cell, std::uint32_t point) {
    if (mesh_.planes_of[point] == 0 && on_wall_[point] == 0) return point;
    const auto [number, is_new] = nodes_.try_emplace(point, cell, static_cast<std::uint32_t>(sets_.count()));
    if (is_new) sets_.add();
    return number;
  }

  void connect() {
    sets_ = DisjointSets(mesh_.point.size());
    for (const auto& [t, shows] : skin_) {
      const std::uint32_t a = node(t.cell, mesh_.point_of[t.vertex[0]]);
      sets_.join(a, node(t.cell, mesh_.point_of[t.vertex[1]]));
      sets_.join(a, node(t.cell, mesh_.point_of[t.vertex[2]]));
      node_of_skin_.push_back(a);
    }
    for (std::size_t c = 0; c < section_.cap.size(); ++c) {
      const Cap& cap = section_.cap[c];
      for (const std::uint32_t cell : cap.closing.cell) {
        if (is_uncut(c)) {
          node_of_cap_.push_back(unset);
          continue;
        }
        const std::uint32_t a = node(cell, cap.point[0]);
        sets_.join(a, node(cell, cap.point[1]));
        sets_.join(a, node(cell, cap.point[2]));
        node_of_cap_.push_back(a);
      }
    }
  }

  std::uint32_t component_at(std::uint32_t node, std::uint32_t cell) {
    std::uint32_t& number = component_of_[sets_.root(node)];
    if (number == unset) {
      number = static_cast<std::uint32_t>(component_.size());
      component_.push_back({cell});
    }
    return number;
  }

  void number_components() {
    component_of_.assign(sets_.count(), unset);
    for (std::size_t t = 0; t < skin_.size(); ++t) component_at(node_of_skin_[t], skin_[t].triangle.cell);
    for (std::size_t c = 0; c < node_of_cap_.size(); ++c) {
      if (node_of_cap_[c] == unset) continue;
      component_at(node_of_cap_[c], section_.cap[c / 2].closing.cell[c % 2]);
    }
  }

  void fill_skins(std::vector<CutPiece>& pieces) {
    PairNumbers vertex_of(mesh_.point_of.size());  // (vertex, component and side) -> vertex of the piece
    for (std::size_t t = 0; t < skin_.size(); ++t) {
      const SurfaceTriangle& skin = skin_[t].triangle;
      const std::uint32_t component = component_at(node_of_skin_[t], skin.cell);
      CutPiece& piece = pieces[component];
      const bool front = skin_[t].shows == SideOf::front;
      const std::int32_t part = (front ? surfaces_.front_part : surfaces_.back_part)[skin.source];
      glm::uvec3 triangle(0);
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t v = skin.vertex[static_cast<std::size_t>(i)];
        const auto [number, is_new] = vertex_of.try_emplace(v, 2 * component + (front ? 1 : 0),
                                                            static_cast<std::uint32_t>(piece.position.size()));
        if (is_new) {
          piece.position.push_back(position(mesh_.point_of[v]));
          piece.normal.push_back(mesh_.normal[v]);
          piece.color.push_back((front ? mesh_.front_color : mesh_.back_color)[v]);
          piece.part.push_back(part);
          piece.bared.push_back(t >= first_wall_ ? 1 : 0);
        }
        triangle[i] = number;
      }
      const auto& p = piece.position;
      if (p[triangle.x] == p[triangle.y] || p[triangle.y] == p[triangle.z] || p[triangle.z] == p[triangle.x]) continue;
      piece.triangle.push_back(triangle);
      piece.surface.push_back(surfaces_.surface[skin.source]);
      if (surfaces_.instance.empty()) continue;
      piece.instance.push_back(surfaces_.instance[skin.source]);
      // A wall is skin of the part that was spared, not of the piece around it.
      if (t < first_wall_) piece.instances.push_back(surfaces_.instance[skin.source]);
    }
    for (CutPiece& piece : pieces) piece.instances = each_once(std::move(piece.instances));
  }

  /// Adds the cut faces. A face inside several bodies closes each of them.
  void fill_caps(std::vector<CutPiece>& pieces) {
    for (std::size_t c = 0; c < node_of_cap_.size(); ++c) {
      if (node_of_cap_[c] == unset) continue;
      const Cap& cap = section_.cap[c / 2];
      CutPiece& piece = pieces[component_at(node_of_cap_[c], cap.closing.cell[c % 2])];
      for (const BodyWinding& inside : cap.closing.inside) {
        const bool reversed = (c % 2 == 1) != (inside.winding < 0);
        for (int i = 0; i < std::abs(inside.winding); ++i)
          piece.caps.push_back({static_cast<std::uint32_t>(c / 2), reversed});
      }
    }
  }

  EdgeBalance measured(CutPiece& piece) const {
    double volume = 0;
    EdgeBalance edges;
    for (const glm::uvec3& t : piece.triangle) {
      const glm::vec3 &a = piece.position[t.x], &b = piece.position[t.y], &c = piece.position[t.z];
      volume += six_volumes(a, b, c);
      edges.add(a, b, c);
    }
    for (const CutPiece::CapTriangle& cap : piece.caps) {
      const glm::uvec3& t = section_.mesh.triangle[cap.triangle];
      const glm::vec3 &a = section_.mesh.position[t.x], &b = section_.mesh.position[cap.reversed ? t.z : t.y],
                      &c = section_.mesh.position[cap.reversed ? t.y : t.z];
      volume += six_volumes(a, b, c);
      edges.add(a, b, c);
    }
    piece.volume = volume / 6;
    return edges;
  }

  /// Joins the parts of each piece into one, and leaves the others empty. Open parts may close each other.
  std::vector<CutPiece> grouped(std::vector<CutPiece> parts) {
    std::vector<std::uint32_t> cell;
    for (const Component& component : component_) cell.push_back(component.cell);
    join(parts, piece_groups(parts, cell, section_.mesh));
    join(parts, homes_of_held(parts, cell, section_.mesh, options_.held_parts));
    join(parts, homes_of_bits(parts, cell, section_.mesh));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      parts[i].closed = edges_[i].closed();
      parts[i].instances = each_once(std::move(parts[i].instances));
    }
    return parts;
  }

  /// \param home index of the part that each part joins; its own if it joins none.
  void join(std::vector<CutPiece>& parts, const std::vector<std::uint32_t>& home) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (home[i] == i) continue;
      absorb(parts[home[i]], std::exchange(parts[i], {}));
      edges_[home[i]].add(std::exchange(edges_[i], {}));
    }
  }

  static void absorb(CutPiece& piece, const CutPiece& part) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    const auto first = static_cast<std::uint32_t>(piece.position.size());
    append(piece.position, part.position);
    append(piece.normal, part.normal);
    append(piece.color, part.color);
    append(piece.part, part.part);
    append(piece.bared, part.bared);
    for (const glm::uvec3& t : part.triangle) piece.triangle.push_back(t + glm::uvec3(first));
    append(piece.surface, part.surface);
    append(piece.instance, part.instance);
    append(piece.caps, part.caps);
    append(piece.instances, part.instances);
    piece.volume += part.volume;
  }

  std::vector<CutPiece> ordered(std::vector<CutPiece> pieces) const {
    double whole = 0;
    for (const CutPiece& piece : pieces) whole += piece.volume;
    for (CutPiece& piece : pieces) piece.crumb = piece.volume < options_.crumb * whole;

    std::vector<std::size_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      if (component_[a].cell != component_[b].cell) return component_[a].cell < component_[b].cell;
      return pieces[a].volume > pieces[b].volume;
    });
    std::vector<CutPiece> sorted;
    for (const std::size_t i : order) {
      if (!pieces[i].triangle.empty() || !pieces[i].caps.empty()) sorted.push_back(std::move(pieces[i]));
    }
    return sorted;
  }

  const SplitMesh& mesh_;
  const Section& section_;
  const std::vector<std::uint8_t>& uncut_;
  const DiffusionSurfaces& surfaces_;
  const CutOptions& options_;

  std::vector<SparedWall> skin_;                           // all that faces air, walls of spared parts too
  std::size_t first_wall_ = 0;                             // of skin_: from here on
  std::vector<std::uint8_t> on_wall_;                      // per point
  PairNumbers nodes_;                                      // (point, cell)
  DisjointSets sets_{0};                                   // of nodes
  std::vector<std::uint32_t> node_of_skin_, node_of_cap_;  // one of each triangle's; caps: two sides each
  std::vector<std::uint32_t> component_of_;                // per root node
  std::vector<Component> component_;
  std::vector<EdgeBalance> edges_;  // per component
};

}  // namespace

std::vector<CutPiece> pieces(const SparedFruit& cut, const DiffusionSurfaces& surfaces, const CutOptions& options) {
  return PieceBuilder(cut, surfaces, options).build();
}

}  // namespace pomona
