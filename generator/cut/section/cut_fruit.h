// A fruit as the knives so far have left it, and what one more way of cutting makes of it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"
#include "generator/cut/section/section.h"
#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A triangle of a surface, or the part of one that lies in one cell. Boundary triangles face air, inner ones are
/// turned as they were.
struct SurfaceTriangle {
  std::array<std::uint32_t, 3> vertex{};  ///< of the split mesh
  std::uint32_t source = 0;               ///< the input triangle it is part of
  std::uint32_t cell = 0;                 ///< of all knives
};

/// All surfaces and cut faces, meeting vertex to vertex.
struct CutFruit {
  SplitMesh mesh;  ///< vertices name the points that stand for their places
  std::vector<SurfaceTriangle> surface;
  Section section;  ///< interior vertices still without colour
};

/// The fruit split, and the faces that were cut, which are not part of its section yet.
struct Cutting {
  CutFruit fruit;
  std::vector<Face> faces;       ///< in cut order
  std::vector<Regions> regions;  ///< per face
  SharedVertices shared;         ///< vertices of earlier faces that the new ones have, too
};

/// With the new faces in its section.
CutFruit with_faces(Cutting cutting, const DiffusionSurfaces& surfaces, Threads threads);

}  // namespace pomona
