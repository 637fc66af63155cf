// Where surfaces cross each other, and themselves.
#pragma once

#include <cstdint>
#include <set>
#include <tuple>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Two triangles that cross, the smaller index first.
struct CrossingTriangles {
  std::uint32_t first = 0, second = 0;
  bool same_piece = false;  ///< surfaces consist of pieces, connected parts: a chamber in each fold
};

/// What crosses what: two surfaces, the smaller index first, or one twice; and whether it is one piece with itself.
using CrossingKind = std::tuple<std::int32_t, std::int32_t, bool>;
CrossingKind kind_of(const DiffusionSurfaces& surfaces, const CrossingTriangles& crossing);
std::set<CrossingKind> kinds_of(const DiffusionSurfaces& surfaces, const std::vector<CrossingTriangles>& crossings);

/// All pairs of triangles that cross properly, an edge of one going through the inside of the other, in order. Decided
/// exactly, for positions rounded to a 2^29th of the bounds' longest side. Touching, a shared edge, and
/// overlapping in one plane do not count; nor does what is not finite.
std::vector<CrossingTriangles> crossing_triangles(const DiffusionSurfaces& surfaces);

/// The kinds of all crossings: kinds_of(surfaces, crossing_triangles(surfaces)).
std::set<CrossingKind> crossing_kinds(const DiffusionSurfaces& surfaces);

/// Those of `wanted` among them. Looks at the surfaces of these alone, and no longer than until each has been found.
std::set<CrossingKind> crossing_kinds_of(const DiffusionSurfaces& surfaces, const std::set<CrossingKind>& wanted);

}  // namespace pomona
