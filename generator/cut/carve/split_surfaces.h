// Surfaces and cut faces of a fruit, split where a closed knife passes through them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "generator/cut/carve/arrangement.h"
#include "generator/cut/section/cut_fruit.h"
#include "generator/surface/bodies.h"

namespace pomona {

/// What bounds the part of a body that lies in one cell, as cells are without the knife at work.
struct CellBoundary {
  std::uint32_t cell = 0;
  std::int32_t body = 0;
  int winding = 0;  ///< how much oftener the part winds around what is behind the boundary than before it
};

/// A segment of the knife's surface. Seen from outside the knife, the front of what passes through it there lies left
/// of the way.
struct KnifeEdge {
  std::uint32_t from = 0, to = 0;  ///< places
  std::vector<CellBoundary> boundary;
};

/// A boundary triangle of the fruit, or a triangle of its section, by what it bounds.
std::vector<CellBoundary> boundary_of(const SurfaceTriangle& skin, const Bodies& bodies);
std::vector<CellBoundary> boundary_of(const Cap& cap);

/// What the fruit leaves on the knife's surface.
struct KnifeTraces {
  std::vector<CutSegment> segments;  ///< of surfaces
  std::vector<KnifeEdge> edges;      ///< of skins and of earlier cut faces
  SharedVertices shared;             ///< of earlier cut faces, where the knife's surface has its vertices, too
};

/// What of the fruit is arranged with the knife, and where its parts lie.
struct FruitParts {
  const Arrangement& all;
  const std::vector<std::vector<int>>& winding;  ///< of the knife, per facet, per part
  std::span<const std::uint32_t> surface;        ///< facets of the arrangement: first these triangles of the fruit,
  std::span<const std::uint32_t> cap;            ///< then these of its section
  std::uint32_t stride = 1;                      ///< cells inside the knife have a number greater by this
};

struct SplitFruit {
  CutFruit fruit;
  KnifeTraces traces;
};

/// Points of the arrangement must be points of the fruit's mesh already.
SplitFruit split_surfaces(CutFruit fruit, const FruitParts& parts, const DiffusionSurfaces& surfaces,
                          const Bodies& bodies);

}  // namespace pomona
