// A fruit as the knives have cut it so far, and the result of one more cut.
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

/// A triangle of a surface, or the part of one that lies in one cell. Boundary triangles face air; inner ones keep
/// their orientation.
struct SurfaceTriangle {
  std::array<std::uint32_t, 3> vertex{};  ///< of the split mesh
  std::uint32_t source = 0;               ///< the input triangle it is part of
  std::uint32_t cell = 0;                 ///< of all knives
};

/// All surfaces and cut faces; they share all vertices.
struct CutFruit {
  SplitMesh mesh;  ///< vertices refer to the representative of their point (same_as)
  std::vector<SurfaceTriangle> surface;
  Section section;  ///< interior vertices still without colour
};

/// A split fruit, and its new cut faces, which are not yet part of its section.
struct Cutting {
  CutFruit fruit;
  std::vector<Face> faces;       ///< in cut order
  std::vector<Regions> regions;  ///< per face
  SharedVertices shared;         ///< vertices of earlier faces that the new faces also use
};

/// The fruit with the new faces in its section.
CutFruit with_faces(Cutting cutting, const DiffusionSurfaces& surfaces, Threads threads);

}  // namespace pomona
