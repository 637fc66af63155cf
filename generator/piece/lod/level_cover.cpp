#include "generator/piece/lod/level_cover.h"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "generator/mesh/box.h"
#include "generator/piece/lod/piece_cover.h"

namespace pomona {
namespace {

constexpr int max_quarterings_of_face = 7;

double squared_distance(const glm::dvec3& p, const TriangleCorners& c) {
  return squared(nearest_on_triangle(p, c) - p);
}

/// The triangles of its patch that hold its corners; for corners that have not been removed, the triangles around them.
std::vector<std::uint32_t> holders_of(const LevelSource& source, const LevelMesh& level, std::uint32_t face) {
  std::vector<std::uint32_t> holders;
  const auto add = [&](std::uint32_t holder) {
    if (holder != none && source.patch[holder] == source.patch[face]) holders.push_back(holder);
  };
  for (const std::uint32_t fan : source.mesh.corner[face])
    if (!level.mesh.has(fan)) add(level.held.face[2 * fan]), add(level.held.face[2 * fan + 1]);
  if (!holders.empty()) return holders;
  for (const std::uint32_t fan : source.mesh.corner[face])
    if (level.mesh.has(fan)) for_each_spoke(level.mesh, fan, [&](const Spoke& spoke) { add(spoke.face); });
  return holders;
}

bool has_or_holds(const LevelMesh& level, std::uint32_t holder, std::uint32_t fan) {
  if (!level.mesh.has(fan)) return level.held.face[2 * fan] == holder || level.held.face[2 * fan + 1] == holder;
  const auto& corner = level.mesh.corner[holder];
  return corner[0] == fan || corner[1] == fan || corner[2] == fan;
}

/// A triangle that is near all corners. A triangle that holds a corner is near it.
std::uint32_t near_whole(const LevelSource& source, const LevelMesh& level, std::uint32_t face, double bound,
                         std::span<const std::uint32_t> holders) {
  const auto& fan = source.mesh.corner[face];
  for (const std::uint32_t holder : holders) {
    const TriangleCorners c = source.corners(level.mesh.corner[holder]);
    const bool is_near = std::all_of(fan.begin(), fan.end(), [&](std::uint32_t f) {
      return has_or_holds(level, holder, f) || squared_distance(source.position[f], c) <= bound * bound;
    });
    if (is_near) return holder;
  }
  return none;
}

/// Triangles of a level, each once.
bool is_covered_by(const LevelSource& source, const LevelMesh& level, std::uint32_t face, double bound,
                   std::vector<std::uint32_t> triangles) {
  const TriangleCorners c = source.corners(source.mesh.corner[face]);
  const Box<double> box = box_around(c[0], c[1], c[2]);
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  std::vector<CoveringTriangle> near;
  for (const std::uint32_t f : triangles) {
    const CoveringTriangle triangle = covering_triangle(source.corners(level.mesh.corner[f]), bound);
    if (triangle.reach.meets(box)) near.push_back(triangle);
  }
  return is_covered(c, near, bound, max_quarterings_of_face);
}

/// Tries the triangles that hold its corners, then those around them, too, and if needed all of its patch.
bool is_near_many(const LevelSource& source, const LevelMesh& level, std::uint32_t face, double bound,
                  const std::vector<std::uint32_t>& holders) {
  if (is_covered_by(source, level, face, bound, holders)) return true;
  std::vector<std::uint32_t> around;
  for (const std::uint32_t holder : holders) {
    for (const std::uint32_t fan : level.mesh.corner[holder]) {
      for_each_spoke(level.mesh, fan, [&](const Spoke& spoke) {
        if (spoke.face != none && source.patch[spoke.face] == source.patch[face]) around.push_back(spoke.face);
      });
    }
  }
  if (is_covered_by(source, level, face, bound, std::move(around))) return true;
  std::vector<std::uint32_t> all;
  for (std::uint32_t f = 0; f < source.patch.size(); ++f)
    if (level.mesh.is_there[f] != 0 && source.patch[f] == source.patch[face]) all.push_back(f);
  return is_covered_by(source, level, face, bound, std::move(all));
}

}  // namespace

std::vector<std::uint32_t> uncovered_faces(const LevelSource& source, const LevelMesh& level, double bound,
                                           const std::vector<std::uint8_t>& changed, std::vector<std::uint32_t>& near) {
  std::vector<std::uint32_t> uncovered;
  for (std::uint32_t f = 0; f < source.patch.size(); ++f) {
    if (near[f] != none && level.mesh.is_there[near[f]] != 0 && changed[near[f]] == 0) continue;
    const std::vector<std::uint32_t> holders = holders_of(source, level, f);
    near[f] = near_whole(source, level, f, bound, holders);
    if (near[f] == none && !is_near_many(source, level, f, bound, holders)) uncovered.push_back(f);
  }
  return uncovered;
}

}  // namespace pomona
