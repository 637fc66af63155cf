// Crossings of surfaces with each other and with themselves.
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
  bool same_piece = false;  ///< both lie in one connected part of a surface, for example in the chamber of one fold
};

/// The kind of a crossing: two surfaces (the smaller index first, or the same twice), and whether it is one connected
/// part.
using CrossingKind = std::tuple<std::int32_t, std::int32_t, bool>;
CrossingKind kind_of(const DiffusionSurfaces& surfaces, const CrossingTriangles& crossing);
std::set<CrossingKind> kinds_of(const DiffusionSurfaces& surfaces, const std::vector<CrossingTriangles>& crossings);

/// All pairs of triangles that cross properly (an edge of one goes through the inside of the other), sorted. The test
/// is exact, for positions rounded to a 2^29th of the bounds' longest side. Touching, a shared edge, and an overlap in
/// one plane do not count; triangles that are not finite are ignored. Places and triangles are enough.
std::vector<CrossingTriangles> crossing_triangles(const DiffusionSurfaces& surfaces);

/// The kinds of all crossings: kinds_of(surfaces, crossing_triangles(surfaces)).
std::set<CrossingKind> crossing_kinds(const DiffusionSurfaces& surfaces);

/// The kinds of `wanted` that occur. Tests only the surfaces of these kinds, and stops when each kind is found.
std::set<CrossingKind> crossing_kinds_of(const DiffusionSurfaces& surfaces, const std::set<CrossingKind>& wanted);

}  // namespace pomona
