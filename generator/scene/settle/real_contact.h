// How real meshes touch: what a heap is judged by.
#pragma once

#include <optional>

#include "generator/mesh/triangle_tree.h"

namespace pomona {

/// A mesh already turned, and where it stands. `size` is the diagonal of its box before it was turned.
struct PlacedMesh {
  TriangleTree mesh;
  glm::dvec3 at{0};
  double size = 0;
};

/// Two meshes inside one another: moving the first by `depth` along `away` takes the deepest point out.
struct Overlap {
  double depth = 0;
  glm::dvec3 away{0};
};

/// The deepest place where one mesh is inside the other, over the vertices and triangle centres of both:
/// how far that point is from the other's surface. Nothing where the meshes are apart or merely touch.
std::optional<Overlap> overlap(const PlacedMesh& a, const PlacedMesh& b);

/// The distance between the surfaces if it is below `within`, else infinity.
double distance(const PlacedMesh& a, const PlacedMesh& b, double within);

}  // namespace pomona
