// Triangles with their neighbours: the mesh of a level, from which vertices are removed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "generator/piece/lod/vertex_fans.h"

namespace pomona {

/// A fan, face, half-edge or chain that is not there.
constexpr std::uint32_t none = 0xffffffffu;

/// Half-edge 3 f + i runs from corner i of face f to the next one, the face on its left.
struct FanMesh {
  std::vector<std::array<std::uint32_t, 3>> corner;  ///< per face: fans
  std::vector<std::uint8_t> is_there;                ///< per face
  std::vector<std::uint32_t> twin;                   ///< per half-edge: the opposite one; none where the solid is open
  std::vector<std::uint32_t> leave;   ///< per fan: a half-edge that starts there; none where the fan is gone
  std::vector<std::uint8_t> is_open;  ///< per fan: 1 where its faces do not go all the way around; this never changes

  std::uint32_t from(std::uint32_t h) const { return corner[h / 3][h % 3]; }
  std::uint32_t to(std::uint32_t h) const { return from(next(h)); }
  bool has(std::uint32_t fan) const { return leave[fan] != none; }

  /// A half-edge that starts at the fan; where it is open, the first one counter-clockwise.
  std::uint32_t first_spoke(std::uint32_t fan) const {
    std::uint32_t h = leave[fan];
    while (is_open[fan] != 0 && twin[h] != none) h = next(twin[h]);
    return h;
  }

  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t before(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
};

FanMesh fan_mesh(const VertexFans& fans);

/// One of the edges at a fan.
struct Spoke {
  std::uint32_t fan = 0;        ///< at its other end
  std::uint32_t half_edge = 0;  ///< along it, away from the middle; where that is open, towards it
  std::uint32_t face = 0;       ///< between this spoke and the next one; none where the solid is open
};

/// The edges at a fan, counter-clockwise seen from the air.
using Ring = std::vector<Spoke>;

/// Calls visit(Spoke) for the edges at a fan, counter-clockwise, from anywhere on, or from the opening on.
template <typename Visit>
void for_each_spoke(const FanMesh& mesh, std::uint32_t fan, const Visit& visit) {
  const std::uint32_t first = mesh.first_spoke(fan);
  for (std::uint32_t h = first;;) {
    visit(Spoke{mesh.to(h), h, h / 3});
    const std::uint32_t last = FanMesh::before(h);
    h = mesh.twin[last];
    if (h == first) return;
    if (h == none) return visit(Spoke{mesh.from(last), last, none});
  }
}

/// `recycled` gives its memory. In the order of for_each_spoke().
Ring ring_around(const FanMesh& mesh, std::uint32_t fan, Ring recycled = {});

}  // namespace pomona
