// How real meshes, not their convex parts, touch: what a pile is judged by.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "generator/base/parallel.h"
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

/// How one piece fits into a pile, as shares of its size. Penetration: the deepest overlap with any other
/// mesh. Gap: the distance to the nearest other mesh, which is what keeps it from falling; 0 if they overlap.
struct Fit {
  double gap = 0;
  double penetration = 0;
};

/// One fit per piece, among the others and the stand.
std::vector<Fit> measure_fits(std::span<const PlacedMesh> pieces, const PlacedMesh& stand, Threads threads = {});

}  // namespace pomona
