#include "generator/surface/touching_solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/base/units.h"
#include "generator/mesh/disjoint_sets.h"
#include "generator/mesh/edges.h"
#include "generator/mesh/enclosures.h"
#include "generator/surface/edge_leaves.h"
#include "generator/surface/turned_sets.h"

namespace pomona {

namespace {

/// So many triangles at one edge are no solids.
constexpr std::size_t crowd = 64;

/// Angles that differ by less are one.
constexpr double same_angle = 1e-6;

bool at_one_angle(const EdgeLeaf& a, const EdgeLeaf& b) {
  const double apart = std::fabs(b.angle - a.angle);
  return std::min(apart, 2 * pi - apart) <= same_angle;
}

/// True if solid, as the triangles face, lies twice at some angle around the edge, or less than not at all.
bool face_different_ways(const std::vector<EdgeLeaf>& leaves) {
  int now = 0, least = 0, most = 0;
  for (const EdgeLeaf& leaf : leaves) {
    now += leaf.forward ? -1 : 1;
    least = std::min(least, now);
    most = std::max(most, now);
  }
  return now != 0 || most - least > 1;
}

/// True if two triangles at one place face the same way: solids that share a face would face it against each other.
bool some_face_alike(const std::vector<EdgeLeaf>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const EdgeLeaf &a = leaves[i], &b = leaves[(i + 1) % leaves.size()];
    if (a.forward == b.forward && at_one_angle(a, b)) return true;
  }
  return false;
}

class TouchingSolids {
 public:
  TouchingSolids(const DiffusionSurfaces& surfaces, std::span<const glm::uvec3> triangles)
      : surfaces_(surfaces),
        triangles_(triangles),
        half_edges_(sorted_half_edges(triangles)),
        parts_(triangles.size()),
        patches_(triangles.size()),
        decided_(triangles.size()),
        has_partner_(triangles.size(), false),
        next_in_file_(triangles.size()) {}

  std::vector<std::uint8_t> turns() {
    std::vector<std::uint8_t> turns(triangles_.size(), 0);
    if (!find_wrong_parts()) return turns;
    find_patches();
    decide_by_places();
    decide_by_partners();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!is_wrong(t)) continue;
      const TurnedSets::Root patch = patches_.root(t);
      turns[t] = static_cast<std::uint8_t>(patch.turned ^ decided_[patch.root].value_or(0));
    }
    return turns;
  }

 private:
  /// Just in front of a triangle, and just behind it.
  using Windings = std::array<int, 2>;

  bool is_wrong(std::uint32_t triangle) { return wrong_[parts_.root(triangle)] != 0; }

  glm::dvec3 corner(std::uint32_t triangle, int k) const {
    return glm::dvec3(surfaces_.position[triangles_[triangle][k]]);
  }

  template <typename Visit>
  void for_each_wrong_edge(const Visit& visit) {
    for_each_edge(half_edges_, [&](std::span<const HalfEdge> edge) {
      if (is_wrong(edge.front().triangle)) visit(edge);
    });
  }

  // ---- Parts: all that hangs together by edges ----

  /// False if there are none.
  bool find_wrong_parts() {
    for_each_edge(half_edges_, [&](std::span<const HalfEdge> edge) {
      for (const HalfEdge& h : edge) parts_.join(edge.front().triangle, h.triangle);
    });
    wrong_.assign(triangles_.size(), 0);
    std::vector<std::uint8_t> unclear(triangles_.size(), 0), alike(triangles_.size(), 0);
    for_each_edge(half_edges_, [&](std::span<const HalfEdge> edge) {
      const std::uint32_t part = parts_.root(edge.front().triangle);
      if (edge.size() % 2 != 0 || edge.size() > crowd) unclear[part] = 1;
      if (edge.size() <= 2 || unclear[part] != 0 || alike[part] != 0) return;
      const std::vector<EdgeLeaf> leaves = leaves_around(edge, triangles_, surfaces_.position);
      if (some_face_alike(leaves)) alike[part] = 1;
      if (face_different_ways(leaves)) wrong_[part] = 1;
    });
    for (std::size_t i = 0; i < wrong_.size(); ++i)
      if (unclear[i] != 0) wrong_[i] = 0;
    find_space();

    // Solids that face outwards and cross each other are no fault: nowhere is less than nothing.
    std::vector<std::uint8_t> negative(triangles_.size(), 0);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const std::uint32_t part = parts_.root(t);
      if (wrong_[part] == 0 || alike[part] != 0 || negative[part] != 0) continue;
      const std::optional<Windings> windings = windings_beside(t);
      if (windings && std::min((*windings)[0], (*windings)[1]) < 0) negative[part] = 1;
    }
    for (std::size_t i = 0; i < wrong_.size(); ++i)
      if (alike[i] == 0 && negative[i] == 0) wrong_[i] = 0;
    return std::any_of(wrong_.begin(), wrong_.end(), [](std::uint8_t wrong) { return wrong != 0; });
  }

  void find_space() {
    std::vector<Enclosures::Triangle> walls;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (is_wrong(t) && !is_collapsed(triangles_[t]))
        walls.push_back({.corner = {corner(t, 0), corner(t, 1), corner(t, 2)}, .mesh = parts_.root(t)});
    }
    space_ = Enclosures(std::move(walls));
  }

  /// How often the triangle's part winds around the places beside it; nothing for one without area.
  std::optional<Windings> windings_beside(std::uint32_t triangle) {
    const glm::dvec3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double twice = glm::length(area);
    if (!(twice > 0)) return std::nullopt;
    constexpr double depth = 1e-4;  // as a share of the triangle's size
    const glm::dvec3 step = depth * area / std::sqrt(twice);
    const auto winding = [&](const glm::dvec3& place) {
      for (const auto& [part, times] : space_.around(place))
        if (part == parts_.root(triangle)) return times;
      return 0;
    };
    const glm::dvec3 middle = (a + b + c) / 3.0;
    return Windings{winding(middle + step), winding(middle - step)};
  }

  // ---- Patches: triangles that surely face alike ----

  void find_patches() {
    for_each_wrong_edge([&](std::span<const HalfEdge> edge) {
      if (edge.size() == 2) return join(edge[0], edge[1]);
      join_pairs(edge, [&](const HalfEdge& h) {
        return std::tuple(0, own_vertex(h.triangle, h.low), own_vertex(h.triangle, h.high));
      });
      join_pairs(edge, [&](const HalfEdge& h) { return surfaces_.surface[h.triangle]; });
    });
  }

  void join(const HalfEdge& a, const HalfEdge& b) { patches_.join(a.triangle, b.triangle, a.forward == b.forward); }

  /// Joins the two half-edges of each key that exactly two have.
  template <typename KeyOf>
  void join_pairs(std::span<const HalfEdge> edge, const KeyOf& key_of) {
    std::map<decltype(key_of(edge.front())), std::vector<const HalfEdge*>> of_key;
    for (const HalfEdge& h : edge) of_key[key_of(h)].push_back(&h);
    for (const auto& [key, sides] : of_key)
      if (sides.size() == 2) join(*sides[0], *sides[1]);
  }

  /// The triangle's vertex before welding.
  std::uint32_t own_vertex(std::uint32_t triangle, std::uint32_t welded) const {
    for (int k = 0; k < 2; ++k) {
      const std::uint32_t own = surfaces_.triangle[triangle][k];
      if (surfaces_.position[own] == surfaces_.position[welded]) return own;
    }
    return surfaces_.triangle[triangle].z;
  }

  // ---- Patches with solid on one side ----

  void decide_by_places() {
    std::vector<std::vector<std::uint32_t>> members(triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
      if (is_wrong(t) && !is_collapsed(triangles_[t])) members[patches_.root(t).root].push_back(t);
    for (std::size_t root = 0; root < members.size(); ++root)
      if (!members[root].empty()) decided_[root] = turn_of_patch(members[root]);
  }

  /// Whether the patch turns; nothing if solid lies on both its sides or on neither, or if it crosses others.
  std::optional<std::uint8_t> turn_of_patch(const std::vector<std::uint32_t>& patch) {
    std::array<std::size_t, 2> votes{0, 0};  // to stay, to turn
    std::size_t between_solids = 0;
    const std::size_t samples = std::min<std::size_t>(16, patch.size());
    for (std::size_t k = 0; k < samples; ++k) {
      const std::uint32_t t = patch[k * patch.size() / samples];
      const std::optional<Windings> windings = windings_beside(t);
      if (!windings) continue;
      const bool in_front = (*windings)[0] % 2 != 0, behind = (*windings)[1] % 2 != 0;
      if (in_front != behind)
        ++votes[in_front != (patches_.root(t).turned != 0) ? 1 : 0];
      else if (in_front)
        ++between_solids;
    }
    const std::size_t all = votes[0] + votes[1];
    if (all == 0) return between_solids > 0 ? turn_by_volume(patch) : std::nullopt;
    if (4 * votes[0] >= 3 * all) return std::uint8_t{0};
    if (4 * votes[1] >= 3 * all) return std::uint8_t{1};
    return std::nullopt;
  }

  /// A closed patch among others on all its sides is a solid by itself; nothing if it is not closed.
  std::optional<std::uint8_t> turn_by_volume(const std::vector<std::uint32_t>& patch) {
    std::vector<glm::uvec3> as_root;
    double volume = 0;
    const glm::dvec3 origin = corner(patch.front(), 0);
    for (const std::uint32_t t : patch) {
      as_root.push_back(triangles_[t]);
      const bool is_turned = patches_.root(t).turned != 0;
      if (is_turned) std::swap(as_root.back().y, as_root.back().z);
      const double six = glm::dot(corner(t, 0) - origin, glm::cross(corner(t, 1) - origin, corner(t, 2) - origin));
      volume += is_turned ? -six : six;
    }
    if (!is_closed(as_root)) return std::nullopt;
    return static_cast<std::uint8_t>(volume < 0 ? 1 : 0);
  }

  // ---- Patches between solids ----

  /// Two patches at one place face each other's solid. Where neither is decided, each keeps to the one next to it in
  /// the file, so that a solid keeps its own triangles.
  void decide_by_partners() {
    TurnedSets partners(triangles_.size());
    for_each_wrong_edge([&](std::span<const HalfEdge> edge) {
      if (edge.size() <= 2) return;
      join_partners(leaves_around(edge, triangles_, surfaces_.position), partners);
      find_next_in_file(edge);
    });
    std::vector<int> votes(triangles_.size(), 0);  // to turn less to stay, for each root of partners
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (!decided_[t] && next_in_file_[t].away == NextInFile::nothing) continue;
      constexpr int sure = 1 << 20;
      const bool turns = decided_[t].value_or(next_in_file_[t].turns) != 0;
      const TurnedSets::Root set = partners.root(t);
      votes[set.root] += (turns != (set.turned != 0) ? 1 : -1) * (decided_[t] ? sure : 1);
    }
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      if (decided_[t] || !has_partner_[t]) continue;
      const TurnedSets::Root set = partners.root(t);
      decided_[t] = static_cast<std::uint8_t>((votes[set.root] > 0 ? 1 : 0) ^ set.turned);
    }
  }

  void join_partners(const std::vector<EdgeLeaf>& leaves, TurnedSets& partners) {
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      const EdgeLeaf &a = leaves[i], &b = leaves[(i + 1) % leaves.size()];
      if (!at_one_angle(a, b)) continue;
      const TurnedSets::Root x = patches_.root(a.triangle), y = patches_.root(b.triangle);
      if (x.root == y.root || (decided_[x.root] && decided_[y.root])) continue;
      partners.join(x.root, y.root, ((a.forward == b.forward) != (x.turned != y.turned)));
      has_partner_[x.root] = has_partner_[y.root] = true;
      ++i;
    }
  }

  /// For patches at the edge that are not decided.
  void find_next_in_file(std::span<const HalfEdge> edge) {
    for (const HalfEdge& open : edge) {
      const TurnedSets::Root patch = patches_.root(open.triangle);
      if (decided_[patch.root]) continue;
      NextInFile& next = next_in_file_[patch.root];
      for (const HalfEdge& sure : edge) {
        const TurnedSets::Root beside = patches_.root(sure.triangle);
        if (!decided_[beside.root]) continue;
        const std::uint32_t away = std::max(open.triangle, sure.triangle) - std::min(open.triangle, sure.triangle);
        if (away >= next.away) continue;
        const bool runs_forward = sure.forward != ((beside.turned ^ *decided_[beside.root]) != 0);
        next = {away, static_cast<std::uint8_t>((open.forward == runs_forward ? 1 : 0) ^ patch.turned)};
      }
    }
  }

  /// The decided triangle at an edge of a patch that comes next to it in the file.
  struct NextInFile {
    static constexpr std::uint32_t nothing = 0xffffffff;
    std::uint32_t away = nothing;
    std::uint8_t turns = 0;  ///< whether the patch's root turns, to face as that triangle does
  };

  const DiffusionSurfaces& surfaces_;
  std::span<const glm::uvec3> triangles_;
  std::vector<HalfEdge> half_edges_;
  DisjointSets parts_;
  Enclosures space_{{}};             ///< of parts that may be wrong
  std::vector<std::uint8_t> wrong_;  ///< per root of a part: solids in it face different ways
  TurnedSets patches_;
  std::vector<std::optional<std::uint8_t>> decided_;  ///< per root of a patch: whether the root turns
  std::vector<bool> has_partner_;                     ///< per root of a patch
  std::vector<NextInFile> next_in_file_;              ///< per root of a patch
};

}  // namespace

std::vector<std::uint8_t> turns_where_solids_touch(const DiffusionSurfaces& surfaces,
                                                   std::span<const glm::uvec3> triangles) {
  return TouchingSolids(surfaces, triangles).turns();
}

}  // namespace pomona
