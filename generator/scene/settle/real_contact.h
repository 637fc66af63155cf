// Overlap and distance of two meshes, measured exactly: a settled heap is checked by them.
#pragma once

#include <optional>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// A mesh at its place.
struct PlacedMesh {
  TriangleTree mesh;  ///< already rotated
  glm::dvec3 at{0};   ///< translation, metres
  double size = 0;    ///< diagonal of its box before it was rotated, metres
};

/// How deep two meshes overlap.
struct Overlap {
  double depth = 0;    ///< depth of the deepest point, metres
  glm::dvec3 away{0};  ///< moving the first mesh by `depth` in this direction takes the deepest point out
};

/// The deepest of the vertices and triangle centres of either mesh that lie inside the other; its depth is the distance
/// to the other's surface. Nothing where the meshes are apart or only touch.
std::optional<Overlap> overlap(const PlacedMesh& a, const PlacedMesh& b);

/// The distance between the surfaces, metres, if it is below `within`; else infinity.
double distance(const PlacedMesh& a, const PlacedMesh& b, double within);

}  // namespace pomona
