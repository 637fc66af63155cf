#include "generator/piece/lod/collapse.h"

#include <algorithm>

namespace pomona {
namespace {

/// The ends of an edge may share only the neighbours in its triangles, and the last four triangles are kept.
bool keeps_topology(const LevelMesh& level, const Ring& ring) {
  const std::uint32_t to = ring.front().fan;
  const auto is_in_ring = [&](std::uint32_t fan) {
    return std::any_of(ring.begin(), ring.end(), [&](const Spoke& spoke) { return spoke.fan == fan; });
  };
  std::size_t shared = 0;
  for_each_spoke(level.mesh, to, [&](const Spoke& spoke) { shared += is_in_ring(spoke.fan) ? 1 : 0; });
  if (shared != (ring.front().face != none ? 1u : 0u) + (ring.back().face != none ? 1u : 0u)) return false;
  return std::none_of(ring.begin() + 1, ring.end() - 1, [&](const Spoke& spoke) {
    if (spoke.face == none) return false;
    const std::uint32_t across = level.mesh.twin[FanMesh::next(spoke.half_edge)];
    return across != none && level.mesh.from(FanMesh::before(across)) == to;
  });
}

CollapseTarget target_at(const LevelSource& source, const LevelMesh& level, const Collapse& collapse,
                         const CollapseSector& sector, std::size_t i) {
  const Ring& ring = collapse.ring;
  CollapseTarget target{.face = ring[i].face, .corner = {}};
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t fan = level.mesh.corner[target.face][k];
    target.corner[k] = source.position[fan == collapse.fan ? collapse.to() : fan];
    target.vertex[k] = fan == collapse.fan ? sector.to : level.vertex[target.face][k];
    target.chain[k] = level.chains.of_edge[3 * target.face + k];
  }
  // Sides that are merged with those of vanishing faces.
  if (i == 1 && ring[0].face != none)
    target.chain[ring[1].half_edge % 3] = level.chains.of_edge[FanMesh::next(ring[0].half_edge)];
  if (i + 2 == ring.size() && ring.back().face != none)
    target.chain[FanMesh::before(ring[i].half_edge) % 3] = level.chains.of_edge[FanMesh::next(ring.back().half_edge)];
  return target;
}

/// Adds the faces between two spokes. False if all of them would vanish, or if the vertex would change its part.
bool add_sector(const LevelSource& source, const LevelMesh& level, std::size_t first, std::size_t last,
                Collapse& collapse) {
  const Ring& ring = collapse.ring;
  CollapseSector sector;
  const auto is_lost = [&](std::size_t i) { return i == 0 || i + 1 == ring.size(); };
  for (std::size_t i = first; i < last; ++i) {
    if (ring[i].face != none && is_lost(i)) sector.lost.push_back(ring[i].face);
  }
  if (sector.lost.empty())
    return std::all_of(ring.begin() + static_cast<std::ptrdiff_t>(first),
                       ring.begin() + static_cast<std::ptrdiff_t>(last),
                       [](const Spoke& spoke) { return spoke.face == none; });
  sector.from = level.vertex_at(sector.lost.front(), collapse.fan);
  sector.to = level.vertex_at(sector.lost.front(), collapse.to());
  sector.side = first == 0 ? 0 : 1;
  if (source.solid.part[sector.from] != source.solid.part[sector.to]) return false;
  for (std::size_t i = first; i < last; ++i) {
    if (ring[i].face != none && !is_lost(i)) sector.target.push_back(target_at(source, level, collapse, sector, i));
  }
  const bool has_target = !sector.target.empty();
  collapse.sector.push_back(std::move(sector));
  return has_target;
}

}  // namespace

Ring ring_of_collapse(const LevelMesh& level, std::uint32_t fan, std::uint32_t to, Ring recycled) {
  Ring ring = ring_around(level.mesh, fan, std::move(recycled));
  const auto is_first = [&](const Spoke& spoke) { return spoke.fan == to; };
  std::rotate(ring.begin(), std::find_if(ring.begin(), ring.end(), is_first), ring.end());
  if (ring.size() < 3 || !keeps_topology(level, ring)) ring.clear();
  return ring;
}

std::optional<Collapse> collapse_of(const LevelSource& source, const LevelMesh& level, std::uint32_t fan,
                                    const Ring& ring) {
  Collapse collapse{.ring = ring, .fan = fan, .sector = {}, .border = {}};
  const auto on_border = [&](const Spoke& spoke) { return level.is_border(spoke.half_edge); };
  const auto end = std::find_if(ring.begin() + 1, ring.end(), on_border);
  if (end == ring.end()) {
    if (!add_sector(source, level, 0, ring.size(), collapse)) return std::nullopt;
    return collapse;
  }
  // The faces to the left of the border and those to its right.
  const auto at = static_cast<std::size_t>(end - ring.begin());
  collapse.border = BorderCollapse{.end = end->fan,
                                   .kept = level.chains.of_edge[end->half_edge],
                                   .merged = level.chains.of_edge[ring.front().half_edge]};
  if (!add_sector(source, level, 0, at, collapse) || !add_sector(source, level, at, ring.size(), collapse))
    return std::nullopt;
  return collapse;
}

std::uint32_t merge_chains(BorderChains& chains, const Collapse& collapse) {
  const auto [end, kept, merged] = *collapse.border;
  const std::uint32_t last_before = chains.last[kept];
  (last_before == none ? chains.first[kept] : chains.next[last_before]) = collapse.fan;
  chains.next[collapse.fan] = chains.first[merged];
  chains.last[kept] = chains.first[merged] == none ? collapse.fan : chains.last[merged];
  for (std::uint32_t fan = collapse.fan; fan != none; fan = chains.next[fan]) chains.of_fan[fan] = kept;
  return last_before;
}

void part_chains(BorderChains& chains, const Collapse& collapse, std::uint32_t last_before) {
  const auto [end, kept, merged] = *collapse.border;
  (last_before == none ? chains.first[kept] : chains.next[last_before]) = none;
  chains.last[kept] = last_before;
  chains.of_fan[collapse.fan] = none;
  for (std::uint32_t fan = chains.first[merged]; fan != none; fan = chains.next[fan]) chains.of_fan[fan] = merged;
  chains.next[collapse.fan] = none;
}

namespace {

/// Connects the faces beyond the other two sides of a face. `along` is the side that leads to or from the vertex that
/// is kept: if it is a border, the merged side is one, too.
void remove_face(LevelMesh& level, std::uint32_t along, std::uint32_t vanishing) {
  FanMesh& mesh = level.mesh;
  const std::uint32_t a = mesh.twin[along], b = mesh.twin[vanishing];
  if (a != none) mesh.twin[a] = b;
  if (b != none) mesh.twin[b] = a, level.chains.of_edge[b] = level.chains.of_edge[along];
  mesh.is_there[along / 3] = 0;
  --level.faces;
}

void hold(HeldVertices& held, const CollapseSector& sector) {
  for (const std::uint32_t face : sector.lost) held.first[face] = none;
  for (const CollapseTarget& target : sector.target) held.first[target.face] = none;
  for (const auto& [id, k] : sector.held) {
    held.face[id] = sector.target[k].face;
    held.next[id] = held.first[held.face[id]];
    held.first[held.face[id]] = id;
  }
}

}  // namespace

void apply(LevelMesh& level, const Collapse& collapse) {
  FanMesh& mesh = level.mesh;
  const Spoke &first = collapse.ring.front(), &last = collapse.ring.back();
  if (first.face != none) remove_face(level, FanMesh::next(first.half_edge), FanMesh::before(first.half_edge));
  if (last.face != none) remove_face(level, FanMesh::next(last.half_edge), last.half_edge);
  for (const CollapseSector& sector : collapse.sector) {
    level.held.vertex[2 * collapse.fan + sector.side] = sector.from;
    for (const CollapseTarget& target : sector.target) {
      level.vertex[target.face] = target.vertex;
      for (std::uint32_t k = 0; k < 3; ++k) {
        std::uint32_t& fan = mesh.corner[target.face][k];
        if (fan == collapse.fan) fan = collapse.to();
        mesh.leave[fan] = 3 * target.face + k;
      }
    }
    hold(level.held, sector);
  }
  mesh.leave[collapse.fan] = none;
}

}  // namespace pomona
