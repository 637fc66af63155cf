#include "generator/piece/lod/collapse_rules.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "generator/mesh/triangle_distance.h"
#include "generator/piece/lod/piece_cover.h"

namespace pomona {
namespace {

/// A triangle may turn by 60 degrees in one collapse, and by 80 from the triangle it grew from.
constexpr double min_cosine_now = 0.5, min_cosine_ever = 0.17;

/// Twice the area over the square of the longest edge; 0.87 if all sides are equal. Narrower triangles shade badly.
constexpr double narrowest = 0.03;

/// A 64th of its length is a small part of a triangle.
constexpr int max_quarterings_of_target = 6;

/// Removed vertices must lie within this share of the bound. The rest is for places between them, which level_cover.h
/// checks.
constexpr double share_for_vertices = 0.85;

double squared_roundness(const TriangleCorners& t) {
  const double longest = std::max({squared(t[1] - t[0]), squared(t[2] - t[1]), squared(t[0] - t[2])});
  return longest > 0 ? squared(area_vector(t)) / (longest * longest) : 0;
}

/// True if the angle between two vectors has more than this cosine, which is above 0.
bool is_within(const glm::dvec3& a, const glm::dvec3& b, double cosine) {
  const double product = glm::dot(a, b);
  return product > 0 && product * product > cosine * cosine * squared(a) * squared(b);
}

/// A face as it is, and as it would be with one corner elsewhere.
struct TurnedFace {
  std::uint32_t face = 0;
  TriangleCorners before, after;
  std::array<std::uint32_t, 3> vertex{};  ///< of the solid, after
};

/// False if the triangle would turn over, face against its vertices' normals or become a needle, and did not before.
bool keeps_its_side(const LevelSource& source, const LevelMesh& level, const TurnedFace& turned) {
  const glm::dvec3 normal = area_vector(turned.after), normal_now = area_vector(turned.before);
  if (!(squared(normal) > 0)) return false;
  if (squared(normal_now) > 0 && !is_within(normal, normal_now, min_cosine_now)) return false;
  const glm::dvec3& ever = source.normal[turned.face];
  if (squared(ever) > 0 && !is_within(normal, ever, min_cosine_ever)) return false;
  const auto shade = [&](const glm::dvec3& across, const std::array<std::uint32_t, 3>& vertex) {
    const auto& n = source.solid.normal;
    return glm::dot(across, glm::dvec3(n[vertex[0]]) + glm::dvec3(n[vertex[1]]) + glm::dvec3(n[vertex[2]]));
  };
  if (shade(normal, turned.vertex) < 0 && shade(normal_now, level.vertex[turned.face]) >= 0) return false;
  const double roundness = squared_roundness(turned.after);
  return roundness > narrowest * narrowest || roundness >= squared_roundness(turned.before);
}

/// Everything along the border's two edges must be near the edge that they become.
bool keeps_the_border(const LevelSource& source, const BorderChains& chains, double bound, const Collapse& collapse) {
  const glm::dvec3 &from = source.position[collapse.border->end], &to = source.position[collapse.to()];
  for (std::uint32_t fan = chains.first[collapse.border->kept]; fan != none; fan = chains.next[fan])
    if (squared_distance_to_segment(source.position[fan], from, to) > bound * bound) return false;
  return true;
}

/// Finds the target that is nearest to a vertex. False if it is too far off, faces away or has another colour there.
bool holds(const LevelSource& source, const LevelBounds& bounds, std::uint32_t id, std::uint32_t vertex,
           CollapseSector& sector) {
  const glm::dvec3& p = source.position[id / 2];
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  glm::dvec3 weight(0);
  for (std::size_t k = 0; k < sector.target.size(); ++k) {
    const TriangleCorners& c = sector.target[k].corner;
    const glm::dvec3 w = nearest_weights(p, c[0], c[1], c[2]);
    const double distance = squared(w.x * c[0] + w.y * c[1] + w.z * c[2] - p);
    if (distance < least) least = distance, nearest = k, weight = w;
  }
  const double bound = share_for_vertices * bounds.distance;
  if (!(least <= bound * bound)) return false;
  const CollapseTarget& target = sector.target[nearest];
  if (glm::dot(area_vector(target.corner), glm::dvec3(source.solid.normal[vertex])) < 0) return false;
  glm::dvec3 color(0);
  for (int i = 0; i < 3; ++i)
    color += weight[i] * glm::dvec3(source.solid.color[target.vertex[static_cast<std::size_t>(i)]]);
  sector.held.emplace_back(id, nearest);
  return greatest(seen_color(color) - source.seen[vertex]) <= bounds.color;
}

bool holds_all(const LevelSource& source, const LevelMesh& level, const LevelBounds& bounds, std::uint32_t fan,
               CollapseSector& sector) {
  const HeldVertices& held = level.held;
  const auto holds_those_of = [&](std::uint32_t face) {
    for (std::uint32_t id = held.first[face]; id != none; id = held.next[id])
      if (!holds(source, bounds, id, held.vertex[id], sector)) return false;
    return true;
  };
  sector.held.clear();
  return holds(source, bounds, 2 * fan + sector.side, sector.from, sector) &&
         std::all_of(sector.target.begin(), sector.target.end(),
                     [&](const CollapseTarget& target) { return holds_those_of(target.face); }) &&
         std::all_of(sector.lost.begin(), sector.lost.end(), holds_those_of);
}

/// The triangles of the solid at the corners of a target and at the vertices that its sector holds, as far as they face
/// its way.
std::vector<CoveringTriangle> triangles_near(const LevelSource& source, const LevelMesh& level, double bound,
                                             const CollapseTarget& target, const CollapseSector& sector) {
  std::vector<std::uint32_t> faces;
  const auto add_faces_at = [&](std::uint32_t fan) {
    for_each_spoke(source.mesh, fan, [&](const Spoke& spoke) {
      if (spoke.face != none && source.patch[spoke.face] == source.patch[target.face]) faces.push_back(spoke.face);
    });
  };
  for (const std::uint32_t fan : level.mesh.corner[target.face]) add_faces_at(fan);
  for (const auto& [id, k] : sector.held) add_faces_at(id / 2);
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<CoveringTriangle> near;
  const glm::dvec3 normal = area_vector(target.corner);
  for (const std::uint32_t face : faces) {
    if (glm::dot(source.normal[face], normal) >= 0)
      near.push_back(covering_triangle(source.corners(source.mesh.corner[face]), bound));
  }
  return near;
}

bool lies_near(const LevelSource& source, const LevelMesh& level, double bound, const CollapseTarget& target,
               const CollapseSector& sector, std::uint32_t to, PatchCover& cover) {
  const CoverQuery query{
      .corner = target.corner, .patch = source.patch[target.face], .fan = to, .chain = target.chain, .bound = bound};
  if (cover.covers(query, level.chains)) return true;
  return is_covered(target.corner, triangles_near(source, level, bound, target, sector), bound,
                    max_quarterings_of_target);
}

/// The cheapest checks come first.
bool keeps_to_bounds(const LevelSource& source, const LevelMesh& level, const LevelBounds& bounds, PatchCover& cover,
                     Collapse& collapse) {
  if (collapse.border && !keeps_the_border(source, level.chains, bounds.distance, collapse)) return false;
  for (CollapseSector& sector : collapse.sector) {
    if (!holds_all(source, level, bounds, collapse.fan, sector)) return false;
  }
  for (const CollapseSector& sector : collapse.sector) {
    for (const CollapseTarget& target : sector.target)
      if (!lies_near(source, level, bounds.distance, target, sector, collapse.to(), cover)) return false;
  }
  return true;
}

}  // namespace

bool keeps_sides(const LevelSource& source, const LevelMesh& level, const Ring& ring) {
  const std::uint32_t to = ring.front().fan, first = ring.front().face, last = ring.back().face;
  std::uint32_t vertex = level.vertex_at(first != none ? first : last, to);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    // Beyond the border that the vertex moves along, its neighbour may have another colour.
    if (last != none && level.is_border(ring[i].half_edge)) vertex = level.vertex_at(last, to);
    const std::uint32_t face = ring[i].face;
    if (face == none) continue;
    const std::size_t k = ring[i].half_edge % 3;
    TurnedFace turned{
        .face = face, .before = source.corners(level.mesh.corner[face]), .after = {}, .vertex = level.vertex[face]};
    turned.after = turned.before;
    turned.after[k] = source.position[to], turned.vertex[k] = vertex;
    if (!keeps_its_side(source, level, turned)) return false;
  }
  return true;
}

bool allows(const LevelSource& source, LevelMesh& level, const LevelBounds& bounds, PatchCover& cover,
            Collapse& collapse) {
  if (!collapse.border) return keeps_to_bounds(source, level, bounds, cover, collapse);
  const std::uint32_t last_before = merge_chains(level.chains, collapse);
  if (keeps_to_bounds(source, level, bounds, cover, collapse)) return true;
  part_chains(level.chains, collapse, last_before);
  return false;
}

}  // namespace pomona
