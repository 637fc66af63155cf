// Surfaces and cut faces of a fruit, split where a closed knife passes through them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// The boundary of the part of a body that lies in one cell. The present knife does not yet divide the cells.
struct CellBoundary {
  std::uint32_t cell = 0;
  std::int32_t body = 0;
  int winding = 0;  ///< winding number of the part behind the boundary, less that before it
};

/// A segment on the knife's surface where a boundary passes through it. For a viewer outside the knife, the boundary's
/// front is left of the direction from `from` to `to`.
struct KnifeEdge {
  std::uint32_t from = 0, to = 0;  ///< numbers of points
  std::vector<CellBoundary> boundary;
};

/// The parts that a boundary triangle of the fruit, or a triangle of its section, bounds.
std::vector<CellBoundary> boundary_of(const SurfaceTriangle& skin, const Bodies& bodies);
std::vector<CellBoundary> boundary_of(const Cap& cap);

/// The traces of the fruit on the knife's surface.
struct KnifeTraces {
  std::vector<CutSegment> segments;  ///< of surfaces
  std::vector<KnifeEdge> edges;      ///< of skins and of earlier cut faces
  SharedVertices shared;             ///< of earlier cut faces, where the knife's surface has its vertices, too
};

/// The triangles of the fruit in the arrangement, and which of their parts are inside the knife.
struct FruitParts {
  const Arrangement& all;
  const std::vector<std::vector<int>>& winding;  ///< winding number of the knife, per facet, per part
  std::span<const std::uint32_t> surface;        ///< the fruit's triangles that are the first facets of the arrangement
  std::span<const std::uint32_t> cap;            ///< the triangles of its section that are the facets after these
  std::uint32_t stride = 1;                      ///< the number of a cell inside the knife is larger by this
};

struct SplitFruit {
  CutFruit fruit;
  KnifeTraces traces;
};

/// Points of the arrangement must be points of the fruit's mesh already.
SplitFruit split_surfaces(CutFruit fruit, const FruitParts& parts, const DiffusionSurfaces& surfaces,
                          const Bodies& bodies);

}  // namespace pomona
