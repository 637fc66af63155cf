// A half-edge collapse: a vertex moves to a neighbour, two triangles vanish, the others around it turn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "generator/piece/lod/level_mesh.h"

namespace pomona {

/// A face as a collapse would leave it.
struct CollapseTarget {
  std::uint32_t face = 0;
  TriangleCorners corner;
  std::array<std::uint32_t, 3> vertex{};  ///< of the solid
  std::array<std::uint32_t, 3> chain{};   ///< the border along each side; none where there is none
};

/// The faces of the vertex: all of them, or those on one side of its border.
struct CollapseSector {
  std::vector<CollapseTarget> target;
  std::vector<std::uint32_t> lost;  ///< faces that vanish
  std::uint32_t from = 0, to = 0;   ///< vertices of the solid
  std::uint32_t side = 0;           ///< 0, or 1 to the right of a border

  /// Vertices that are gone, in the numbers of HeldVertices, and the target that would hold each.
  std::vector<std::pair<std::uint32_t, std::size_t>> held;
};

/// A vertex on a border moves along it: two of its edges become one.
struct BorderCollapse {
  std::uint32_t end = 0;               ///< the other neighbour along the border
  std::uint32_t kept = 0, merged = 0;  ///< chains: to the end, and to the neighbour it moves to
};

struct Collapse {
  Ring ring;  ///< begins with the neighbour that the vertex moves to
  std::uint32_t fan = 0;
  std::vector<CollapseSector> sector;
  std::optional<BorderCollapse> border;

  std::uint32_t to() const { return ring.front().fan; }
};

/// The ring of a vertex, beginning with the neighbour that it would move to. Empty if the mesh would not stay a
/// manifold. `recycled` gives its memory.
Ring ring_of_collapse(const LevelMesh& level, std::uint32_t fan, std::uint32_t to, Ring recycled = {});

/// The collapse that moves a vertex to the first neighbour of its ring. Nothing if the vertex would leave its border or
/// part.
std::optional<Collapse> collapse_of(const LevelSource& source, const LevelMesh& level, std::uint32_t fan,
                                    const Ring& ring);

/// Appends the merged chain and the vertex between them to the kept chain. Returns the last fan that the kept chain had
/// before.
std::uint32_t merge_chains(BorderChains& chains, const Collapse& collapse);

/// Undoes merge_chains().
void part_chains(BorderChains& chains, const Collapse& collapse, std::uint32_t last_before);

/// Performs the collapse; its chains must be merged already.
void apply(LevelMesh& level, const Collapse& collapse);

}  // namespace pomona
