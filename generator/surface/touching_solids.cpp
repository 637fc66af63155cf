#include "generator/surface/touching_solids.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/signed_volume.h"
#include "generator/surface/edge_leaves.h"
#include "generator/surface/touching_parts.h"
#include "generator/surface/turned_sets.h"

namespace pomona {

namespace {

/// A patch is a set of triangles that surely face alike. Per triangle: the first of its patch, which stands for the
/// patch, and whether it is turned against that.
using FacingPatches = std::vector<TurnedSets::Root>;

/// Per first triangle of a patch: whether the patch turns; nothing where that is not known.
using Decisions = std::vector<std::optional<std::uint8_t>>;

template <typename Visit>
void for_each_wrong_edge(const EdgedMesh& mesh, const TouchingParts& parts, const Visit& visit) {
  for_each_edge(mesh.half_edges, [&](std::span<const HalfEdge> edge) {
    if (parts.holds_wrong(edge.front().triangle)) visit(edge);
  });
}

// ---- FacingPatches ----

void join(TurnedSets& sets, const HalfEdge& a, const HalfEdge& b) {
  sets.join(a.triangle, b.triangle, a.forward == b.forward);
}

/// Joins the two half-edges of each key that exactly two have.
template <typename KeyOf>
void join_pairs(TurnedSets& sets, std::span<const HalfEdge> edge, const KeyOf& key_of) {
  std::map<decltype(key_of(edge.front())), std::vector<const HalfEdge*>> of_key;
  for (const HalfEdge& h : edge) of_key[key_of(h)].push_back(&h);
  for (const auto& [key, sides] : of_key)
    if (sides.size() == 2) join(sets, *sides[0], *sides[1]);
}

/// The triangle's vertex before welding.
std::uint32_t own_vertex(const DiffusionSurfaces& surfaces, std::uint32_t triangle, std::uint32_t welded) {
  for (int k = 0; k < 2; ++k) {
    const std::uint32_t own = surfaces.triangle[triangle][k];
    if (surfaces.position[own] == surfaces.position[welded]) return own;
  }
  return surfaces.triangle[triangle].z;
}

/// At an edge of many those belong together that share vertices of the file, or that alone are of one surface.
FacingPatches patches_of(const EdgedMesh& mesh, const TouchingParts& parts) {
  TurnedSets sets(mesh.triangles.size());
  for_each_wrong_edge(mesh, parts, [&](std::span<const HalfEdge> edge) {
    if (edge.size() == 2) return join(sets, edge[0], edge[1]);
    join_pairs(sets, edge, [&](const HalfEdge& h) {
      return std::pair(own_vertex(mesh.surfaces, h.triangle, h.low), own_vertex(mesh.surfaces, h.triangle, h.high));
    });
    join_pairs(sets, edge, [&](const HalfEdge& h) { return mesh.surfaces.surface[h.triangle]; });
  });
  FacingPatches patches;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) patches.push_back(sets.root(t));
  return patches;
}

// ---- FacingPatches with solid on one side ----

/// A closed patch among others on all its sides is a solid by itself; nothing if it is not closed.
std::optional<std::uint8_t> turn_by_volume(const EdgedMesh& mesh, const FacingPatches& patches,
                                           const std::vector<std::uint32_t>& patch) {
  std::vector<glm::uvec3> as_first;
  double volume = 0;
  const glm::dvec3 origin = mesh.corner(patch.front(), 0);
  for (const std::uint32_t t : patch) {
    as_first.push_back(mesh.triangles[t]);
    const bool is_turned = patches[t].turned != 0;
    if (is_turned) std::swap(as_first.back().y, as_first.back().z);
    const double six = six_volumes(mesh.corner(t, 0) - origin, mesh.corner(t, 1) - origin, mesh.corner(t, 2) - origin);
    volume += is_turned ? -six : six;
  }
  if (!is_closed(as_first)) return std::nullopt;
  return static_cast<std::uint8_t>(volume < 0 ? 1 : 0);
}

/// Whether the patch turns; nothing if solid lies on both its sides or on neither, or if it crosses others.
std::optional<std::uint8_t> turn_of_patch(const EdgedMesh& mesh, const TouchingParts& parts,
                                          const FacingPatches& patches, const std::vector<std::uint32_t>& patch) {
  std::array<std::size_t, 2> votes{0, 0};  // to stay, to turn
  std::size_t between_solids = 0;
  const std::size_t samples = std::min<std::size_t>(16, patch.size());
  for (std::size_t k = 0; k < samples; ++k) {
    const std::uint32_t t = patch[k * patch.size() / samples];
    const auto windings = windings_beside(mesh, parts, t);
    if (!windings) continue;
    const bool in_front = (*windings)[0] % 2 != 0, behind = (*windings)[1] % 2 != 0;
    if (in_front != behind)
      ++votes[in_front != (patches[t].turned != 0) ? 1 : 0];
    else if (in_front)
      ++between_solids;
  }
  const std::size_t all = votes[0] + votes[1];
  if (all == 0) return between_solids > 0 ? turn_by_volume(mesh, patches, patch) : std::nullopt;
  if (4 * votes[0] >= 3 * all) return std::uint8_t{0};
  if (4 * votes[1] >= 3 * all) return std::uint8_t{1};
  return std::nullopt;
}

Decisions decisions_by_places(const EdgedMesh& mesh, const TouchingParts& parts, const FacingPatches& patches) {
  std::vector<std::vector<std::uint32_t>> members(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    if (parts.holds_wrong(t) && !is_collapsed(mesh.triangles[t])) members[patches[t].root].push_back(t);
  Decisions decided(mesh.triangles.size());
  for (std::size_t first = 0; first < members.size(); ++first)
    if (!members[first].empty()) decided[first] = turn_of_patch(mesh, parts, patches, members[first]);
  return decided;
}

// ---- FacingPatches between solids ----

/// Two patches at one place, of which at least one is not decided, face each other's solid.
struct Partners {
  TurnedSets sets;                   ///< of patches
  std::vector<std::uint8_t> paired;  ///< per patch: it has a partner
};

void join_partners(Partners& partners, const std::vector<EdgeLeaf>& leaves, const FacingPatches& patches,
                   const Decisions& decided) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const EdgeLeaf &a = leaves[i], &b = leaves[(i + 1) % leaves.size()];
    if (!at_one_angle(a, b)) continue;
    const TurnedSets::Root x = patches[a.triangle], y = patches[b.triangle];
    if (x.root == y.root || (decided[x.root] && decided[y.root])) continue;
    partners.sets.join(x.root, y.root, ((a.forward == b.forward) != (x.turned != y.turned)));
    partners.paired[x.root] = partners.paired[y.root] = 1;
    ++i;
  }
}

/// The decided triangle at an edge of a patch that comes next to it in the file.
struct NextInFile {
  static constexpr std::uint32_t nothing = 0xffffffff;
  std::uint32_t away = nothing;
  std::uint8_t turns = 0;  ///< whether the patch turns, to face as that triangle does
};

/// For patches at the edge that are not decided.
void find_next_in_file(std::vector<NextInFile>& next_of, std::span<const HalfEdge> edge, const FacingPatches& patches,
                       const Decisions& decided) {
  for (const HalfEdge& open : edge) {
    const TurnedSets::Root patch = patches[open.triangle];
    if (decided[patch.root]) continue;
    NextInFile& next = next_of[patch.root];
    for (const HalfEdge& sure : edge) {
      const TurnedSets::Root beside = patches[sure.triangle];
      if (!decided[beside.root]) continue;
      const std::uint32_t away = std::max(open.triangle, sure.triangle) - std::min(open.triangle, sure.triangle);
      if (away >= next.away) continue;
      const bool runs_forward = sure.forward != ((beside.turned ^ *decided[beside.root]) != 0);
      next = {away, static_cast<std::uint8_t>((open.forward == runs_forward ? 1 : 0) ^ patch.turned)};
    }
  }
}

/// Decides the patches that have partners. Where neither is decided, each keeps to the one next to it in the file, so
/// that a solid keeps its own triangles.
Decisions decisions_by_partners(const EdgedMesh& mesh, const TouchingParts& parts, const FacingPatches& patches,
                                Decisions decided) {
  const std::size_t count = mesh.triangles.size();
  Partners partners{TurnedSets(count), std::vector<std::uint8_t>(count, 0)};
  std::vector<NextInFile> next(count);
  for_each_wrong_edge(mesh, parts, [&](std::span<const HalfEdge> edge) {
    if (edge.size() <= 2) return;
    join_partners(partners, leaves_around(edge, mesh.triangles, mesh.surfaces.position), patches, decided);
    find_next_in_file(next, edge, patches, decided);
  });
  std::vector<int> votes(count, 0);  // to turn less to stay, for each set of partners
  for (std::uint32_t t = 0; t < count; ++t) {
    if (!decided[t] && next[t].away == NextInFile::nothing) continue;
    constexpr int sure = 1 << 20;
    const bool turns = decided[t].value_or(next[t].turns) != 0;
    const TurnedSets::Root set = partners.sets.root(t);
    votes[set.root] += (turns != (set.turned != 0) ? 1 : -1) * (decided[t] ? sure : 1);
  }
  for (std::uint32_t t = 0; t < count; ++t) {
    if (decided[t] || partners.paired[t] == 0) continue;
    const TurnedSets::Root set = partners.sets.root(t);
    decided[t] = static_cast<std::uint8_t>((votes[set.root] > 0 ? 1 : 0) ^ set.turned);
  }
  return decided;
}

}  // namespace

std::vector<std::uint8_t> turns_where_solids_touch(const DiffusionSurfaces& surfaces,
                                                   std::span<const glm::uvec3> triangles) {
  std::vector<std::uint8_t> turns(triangles.size(), 0);
  const EdgedMesh mesh{surfaces, triangles, sorted_half_edges(triangles)};
  const TouchingParts parts = touching_parts(mesh);
  if (!parts.any_wrong()) return turns;
  const FacingPatches patches = patches_of(mesh, parts);
  const Decisions decided = decisions_by_partners(mesh, parts, patches, decisions_by_places(mesh, parts, patches));
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (parts.holds_wrong(t))
      turns[t] = static_cast<std::uint8_t>(patches[t].turned ^ decided[patches[t].root].value_or(0));
  return turns;
}

}  // namespace pomona
