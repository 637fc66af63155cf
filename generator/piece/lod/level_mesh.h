// The data of decimation: the original solid, the current level, and which vertices of the solid lie on which faces of
// the level.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "generator/mesh/triangle_distance.h"
#include "generator/piece/lod/fan_mesh.h"
#include "generator/piece/solid.h"

namespace pomona {

/// The largest differences of a level from the solid.
struct LevelBounds {
  double distance = 0;  ///< metres: of surface and borders
  double color = 0;     ///< 0..1, of the square root of linear light, which is near sRGB; of each channel
};

/// A triangle of a level.
struct LevelFace {
  std::uint32_t source = 0;  ///< the triangle of the solid it grew from
  glm::uvec3 vertex{0};      ///< of the solid
};

/// The solid, which all levels are compared with. A face has the same number here and in a level.
struct LevelSource {
  const SolidMesh& solid;
  FanMesh mesh;
  std::vector<glm::dvec3> position;                  ///< per fan
  std::vector<glm::dvec3> seen;                      ///< per vertex: its colour's square root
  std::vector<double> area;                          ///< per fan, square metres: a third of the triangles around it
  std::vector<std::array<std::uint32_t, 3>> vertex;  ///< per face
  std::vector<glm::dvec3> normal;                    ///< per face, as long as twice its area
  std::vector<std::uint32_t> patch;                  ///< per face: its cut face or surface

  TriangleCorners corners(const std::array<std::uint32_t, 3>& fan) const {
    return {position[fan[0]], position[fan[1]], position[fan[2]]};
  }
};

/// A border is an edge where the cut face or surface changes, or where a corner has two colours, two parts or very
/// different normals. Each of a level's stands for a chain of the solid's, between the same two ends.
struct BorderChains {
  std::vector<std::uint32_t> of_edge;      ///< per half-edge; none where there is no border
  std::vector<std::uint32_t> first, last;  ///< per chain: fans between its ends, a list through `next`
  std::vector<std::uint32_t> next;         ///< per fan
  std::vector<std::uint32_t> of_fan;       ///< per fan that lies between the ends of a chain; else none
};

/// Removed vertices, on the faces that stand for them. A vertex on a border is listed twice, once for each side.
struct HeldVertices {
  std::vector<std::uint32_t> first;   ///< per face: a list through `next`
  std::vector<std::uint32_t> next;    ///< per fan and side, 2 fan + side
  std::vector<std::uint32_t> face;    ///< the same: none where nothing holds it
  std::vector<std::uint32_t> vertex;  ///< the same: its number in the solid
};

struct LevelMesh {
  FanMesh mesh;
  std::vector<std::array<std::uint32_t, 3>> vertex;  ///< per face: of the solid
  BorderChains chains;
  HeldVertices held;
  std::size_t faces = 0;

  bool is_border(std::uint32_t half_edge) const { return chains.of_edge[half_edge] != none; }
  std::uint32_t vertex_at(std::uint32_t face, std::uint32_t fan) const {
    const auto& c = mesh.corner[face];
    return vertex[face][c[0] == fan ? 0 : c[1] == fan ? 1 : 2];
  }
};

LevelSource level_source(const VertexFans& fans, const SolidMesh& solid);

/// A level equal to the solid.
LevelMesh level_mesh(const LevelSource& source);

std::vector<LevelFace> faces_of(const LevelMesh& level, const VertexFans& fans);

/// The normal of a triangle, of twice its area.
inline glm::dvec3 area_vector(const TriangleCorners& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

inline double squared(const glm::dvec3& v) { return glm::dot(v, v); }

/// The squared distance of p from the segment from a to b.
double squared_distance_to_segment(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b);

/// The square root of light is evenly spaced to the eye, nearly, and the same on all processors.
glm::dvec3 seen_color(const glm::dvec3& linear);

/// The largest of three numbers' absolute values.
double greatest(const glm::dvec3& v);

}  // namespace pomona
