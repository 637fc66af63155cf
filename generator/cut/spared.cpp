#include "generator/cut/spared.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/cut/edge_balance.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edge_map.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/enclosures.h"
#include "generator/mesh/signed_volume.h"
#include "generator/mesh/weld.h"

namespace pomona {

namespace {

constexpr std::uint32_t no_shell = 0xffffffffu;

/// Per triangle of the surfaces, the shell around a spared part that it belongs to: the smallest welded vertex of it.
std::vector<std::uint32_t> shells_of(const DiffusionSurfaces& surfaces, std::span<const int> parts) {
  const auto is_spared = [&](std::int32_t part) { return std::binary_search(parts.begin(), parts.end(), part); };
  const std::vector<std::uint32_t> first = weld(surfaces.position);
  DisjointSets vertices(surfaces.vertex_count());
  std::vector<std::uint32_t> shell(surfaces.triangle_count(), no_shell);
  for (std::size_t t = 0; t < shell.size(); ++t) {
    if (!is_spared(surfaces.back_part[t]) || is_spared(surfaces.front_part[t]) || surfaces.is_boundary(t)) continue;
    const glm::uvec3& corner = surfaces.triangle[t];
    vertices.join(first[corner.x], first[corner.y]);
    vertices.join(first[corner.x], first[corner.z]);
    shell[t] = 0;
  }
  for (std::size_t t = 0; t < shell.size(); ++t)
    if (shell[t] != no_shell) shell[t] = vertices.root(first[surfaces.triangle[t].x]);
  return shell;
}

/// A shell that knives have passed through.
struct CutShell {
  std::vector<std::uint32_t> triangle;  // of the fruit's surfaces
  std::vector<std::uint32_t> cap;       // within it
  bool is_whole = true;                 // it can be spared
  std::uint32_t home = 0;               // the cell that has all of it
};

/// What a shell and the caps within it enclose in one cell.
struct ShellShare {
  double volume = 0;  // six times that, cubic metres
  EdgeBalance edges;
  void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    if (a == b || b == c || c == a) return;  // rounding has made it a line, where its neighbours meet
    volume += six_volumes(a, b, c);
    edges.add(a, b, c);
  }
};

class Sparer {
 public:
  Sparer(CutFruit fruit, const DiffusionSurfaces& surfaces, std::span<const int> parts)
      : fruit_(std::move(fruit)), surfaces_(surfaces), shell_of_(shells_of(surfaces, parts)) {}

  SparedFruit run() {
    find_cut_shells();
    std::vector<SparedWall> walls;
    std::vector<std::uint8_t> uncut(fruit_.section.cap.size(), 0);
    std::set<std::string> names;
    if (!shells_.empty()) find_caps();
    for (auto& [number, shell] : shells_) {
      find_home(shell);
      if (!shell.is_whole) {
        names.insert(name_of(shell));
        continue;
      }
      for (const std::uint32_t c : shell.cap) uncut[c] = 1;
      add_walls(shell, walls);
    }
    std::vector<std::string> warnings;
    for (const std::string& name : names) {
      warnings.push_back("part \"" + name + "\" is cut through in places: what is around it there is open, crosses " +
                         "another such surface or leaves the fruit");
    }
    return {std::move(fruit_), std::move(walls), std::move(uncut), std::move(warnings)};
  }

 private:
  std::uint32_t point(std::uint32_t vertex) const { return fruit_.mesh.point_of[vertex]; }
  glm::vec3 position(std::uint32_t at) const { return glm::vec3(fruit_.mesh.point[at]); }

  const std::string& name_of(const CutShell& shell) const {
    const std::uint32_t source = fruit_.surface[shell.triangle.front()].source;
    return surfaces_.part_names[static_cast<std::size_t>(surfaces_.back_part[source])];
  }

  /// Finds the shells with triangles in several cells.
  void find_cut_shells() {
    std::map<std::uint32_t, std::uint32_t> cell_of;
    std::set<std::uint32_t> cut;
    for (const SurfaceTriangle& t : fruit_.surface) {
      const std::uint32_t shell = shell_of_[t.source];
      if (shell != no_shell && cell_of.try_emplace(shell, t.cell).first->second != t.cell) cut.insert(shell);
    }
    for (std::uint32_t t = 0; t < fruit_.surface.size(); ++t) {
      const std::uint32_t shell = shell_of_[fruit_.surface[t].source];
      if (shell != no_shell && cut.contains(shell)) shells_[shell].triangle.push_back(t);
    }
  }

  /// Where shells pass through cut faces.
  EdgeSet rims() const {
    const SplitMesh& mesh = fruit_.mesh;
    EdgeSet all;
    for (const auto& [number, shell] : shells_) {
      for (const std::uint32_t t : shell.triangle) {
        const std::array<std::uint32_t, 3>& v = fruit_.surface[t].vertex;
        for (std::size_t i = 0; i < 3; ++i) {
          const std::uint32_t p = point(v[i]), q = point(v[(i + 1) % 3]);
          if (mesh.planes_of[p] != 0 && mesh.planes_of[q] != 0) all.insert({p, q});
        }
      }
    }
    return all;
  }

  /// Sets of connected caps that no shell separates.
  DisjointSets patches() const {
    const std::vector<Cap>& caps = fruit_.section.cap;
    const EdgeSet rim = rims();
    DisjointSets patch(caps.size());
    std::vector<glm::uvec3> triangles;
    for (const Cap& cap : caps) triangles.emplace_back(cap.point[0], cap.point[1], cap.point[2]);
    for_each_edge(sorted_half_edges(triangles), [&](std::span<const HalfEdge> edge) {
      if (rim.contains({edge.front().low, edge.front().high})) return;
      for (std::size_t i = 0; i < edge.size(); ++i) {
        for (std::size_t k = i + 1; k < edge.size(); ++k) {
          if (caps[edge[i].triangle].closing.cell == caps[edge[k].triangle].closing.cell)
            patch.join(edge[i].triangle, edge[k].triangle);
        }
      }
    });
    return patch;
  }

  /// Finds the shell of each patch of caps, by its largest triangle. A patch in two shells, which cross, is in none.
  void find_caps() {
    std::vector<Enclosures::Triangle> triangles;
    for (std::size_t t = 0; t < shell_of_.size(); ++t) {
      if (!shells_.contains(shell_of_[t])) continue;
      const glm::uvec3& corner = surfaces_.triangle[t];
      const auto at = [&](std::uint32_t v) { return glm::dvec3(surfaces_.position[v]); };
      triangles.push_back({{at(corner.x), at(corner.y), at(corner.z)}, shell_of_[t]});
    }
    const Enclosures shells(std::move(triangles));

    DisjointSets patch = patches();
    std::map<std::uint32_t, std::pair<double, std::uint32_t>> largest;  // per patch: area, triangle
    std::map<std::uint32_t, std::vector<std::uint32_t>> of_patch;
    const std::vector<Cap>& caps = fruit_.section.cap;
    for (std::uint32_t c = 0; c < caps.size(); ++c) {
      const auto at = [&](std::size_t i) { return fruit_.mesh.point[caps[c].point[i]]; };
      const double area = glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
      const std::uint32_t root = patch.root(c);
      of_patch[root].push_back(c);
      const auto [entry, is_new] = largest.try_emplace(root, area, c);
      if (!is_new && area > entry->second.first) entry->second = {area, c};
    }
    for (const auto& [root, found] : largest) {
      const Cap& cap = caps[found.second];
      const glm::dvec3 middle =
          (fruit_.mesh.point[cap.point[0]] + fruit_.mesh.point[cap.point[1]] + fruit_.mesh.point[cap.point[2]]) / 3.0;
      const auto around = shells.around(middle);
      for (const auto& [shell, winding] : around) {
        CutShell& one = shells_.at(shell);
        if (around.size() > 1 || winding != 1) one.is_whole = false;
        one.cap.insert(one.cap.end(), of_patch[root].begin(), of_patch[root].end());
      }
    }
  }

  /// Finds the cell that gets the shell, and whether shell and caps close in each cell; else nothing is moved.
  void find_home(CutShell& shell) const {
    std::map<std::uint32_t, ShellShare> in_cell;
    for (const std::uint32_t t : shell.triangle) {
      const SurfaceTriangle& whole = fruit_.surface[t];
      in_cell[whole.cell].add(position(point(whole.vertex[0])), position(point(whole.vertex[1])),
                              position(point(whole.vertex[2])));
    }
    for (const std::uint32_t c : shell.cap) {
      const Cap& cap = fruit_.section.cap[c];
      const std::vector<BodyWinding>& inside = cap.closing.inside;
      if (inside.size() != 1 || inside.front().winding != 1) shell.is_whole = false;
      const glm::vec3 p = position(cap.point[0]), q = position(cap.point[1]), r = position(cap.point[2]);
      in_cell[cap.closing.cell[0]].add(p, q, r);
      in_cell[cap.closing.cell[1]].add(p, r, q);
    }
    double max = 0;
    for (const auto& [cell, share] : in_cell) {
      shell.is_whole = shell.is_whole && share.edges.closed();
      max = std::max(max, share.volume);
    }
    for (const auto& [cell, share] : in_cell) {
      if (share.volume < nearly_as_much * max) continue;
      shell.home = cell;
      return;
    }
  }

  /// Adds the walls that are not at home: the part's outside for its piece, the socket for the others.
  void add_walls(const CutShell& shell, std::vector<SparedWall>& walls) {
    const std::map<std::uint32_t, glm::vec3> normal = normals_of(shell);
    std::map<std::uint32_t, std::uint32_t> outside, socket;  // the walls' vertices
    for (const std::uint32_t t : shell.triangle) {
      const SurfaceTriangle whole = fruit_.surface[t];
      if (whole.cell == shell.home) continue;
      for (const SideOf side : {SideOf::back, SideOf::front}) {
        const bool is_socket = side == SideOf::front;
        auto& vertex_of = is_socket ? socket : outside;
        SurfaceTriangle wall = whole;
        for (std::uint32_t& v : wall.vertex) {
          const auto [entry, is_new] = vertex_of.try_emplace(v, 0u);
          if (is_new) entry->second = copy_of(v, is_socket ? -normal.at(point(v)) : normal.at(point(v)));
          v = entry->second;
        }
        if (is_socket) std::swap(wall.vertex[1], wall.vertex[2]);
        wall.cell = is_socket ? whole.cell : shell.home;
        walls.push_back({wall, side});
      }
    }
  }

  std::uint32_t copy_of(std::uint32_t v, const glm::vec3& to_air) {
    SplitMesh& mesh = fruit_.mesh;
    const Color front = mesh.front_color[v], back = mesh.back_color[v];
    return mesh.add_vertex(mesh.point_of[v], front, back, to_air);
  }

  /// Normals at the shell's points, outwards: area-weighted means of its triangles.
  std::map<std::uint32_t, glm::vec3> normals_of(const CutShell& shell) const {
    std::map<std::uint32_t, glm::vec3> sum;
    for (const std::uint32_t t : shell.triangle) {
      const std::array<std::uint32_t, 3>& v = fruit_.surface[t].vertex;
      const glm::dvec3 &a = fruit_.mesh.place_of(v[0]), &b = fruit_.mesh.place_of(v[1]),
                       &c = fruit_.mesh.place_of(v[2]);
      const glm::vec3 normal(glm::cross(b - a, c - a) * 1e6);  // square millimetres
      for (const std::uint32_t corner : v) sum.try_emplace(point(corner), 0.0f).first->second += normal;
    }
    for (auto& [at, normal] : sum) {
      const float size = glm::length(normal);
      if (size > 0) normal /= size;
    }
    return sum;
  }

  CutFruit fruit_;
  const DiffusionSurfaces& surfaces_;
  const std::vector<std::uint32_t> shell_of_;  // per triangle of the surfaces
  std::map<std::uint32_t, CutShell> shells_;   // that are cut
};

}  // namespace

std::vector<std::uint32_t> closed_shells(const DiffusionSurfaces& surfaces, std::span<const int> parts) {
  std::vector<std::uint32_t> shell = shells_of(surfaces, parts);
  std::map<std::uint32_t, EdgeBalance> edges;
  for (std::size_t t = 0; t < shell.size(); ++t) {
    if (shell[t] == no_shell) continue;
    const glm::uvec3& v = surfaces.triangle[t];
    edges[shell[t]].add(surfaces.position[v.x], surfaces.position[v.y], surfaces.position[v.z]);
  }
  std::map<std::uint32_t, std::uint32_t> number;
  for (std::uint32_t& one : shell) {
    const bool is_closed = one != no_shell && edges.at(one).closed();
    one = is_closed ? number.try_emplace(one, static_cast<std::uint32_t>(number.size() + 1)).first->second : 0;
  }
  return shell;
}

SparedFruit spared(CutFruit fruit, const DiffusionSurfaces& surfaces, std::span<const int> parts) {
  if (parts.empty()) return {std::move(fruit), {}, {}, {}};
  return Sparer(std::move(fruit), surfaces, parts).run();
}

}  // namespace pomona
