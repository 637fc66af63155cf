// All diffusion surfaces, split along all cutting planes. Everything that later steps ask - what is cut, which side is
// which, what belongs to which cell - is recorded here as it happens, by identity, and never asked of coordinates
// again.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/knife/cut_planes.h"
#include "generator/knife/placed_knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

struct SplitMesh {
  explicit SplitMesh(const CutPlanes& planes) : sets(planes) {}

  // Points: places in space. Input vertices at equal positions are one point; so are the two ends at which two
  // triangles meet a plane on their common edge.
  std::vector<glm::dvec3> point;         ///< those of the input first
  std::vector<std::uint32_t> planes_of;  ///< per point: which planes it lies on, a number in `sets`

  // Vertices: points with the attributes that a surface has there. The first are those of the input.
  std::vector<std::uint32_t> point_of;
  std::vector<Color> front_color, back_color;
  std::vector<glm::vec3> normal;  ///< to air, smooth; only where a boundary triangle uses the vertex

  struct Triangle {
    std::array<std::uint32_t, 3> vertex{};
    std::uint32_t source = 0;  ///< the input triangle it is part of
    std::uint32_t cell = 0;    ///< of all knives; cells are numbered knife by knife, the first knife's slowest
    /// Per edge (from corner i to i + 1): the planes it is cut by, of which the triangle lies on the negative side.
    std::array<std::uint32_t, 3> cut_by{};
    KnifeSides sides;  ///< of the knife at work; of no meaning in the result
  };
  std::vector<Triangle> triangle;

  PlaneSets sets;
};

SplitMesh split(const DiffusionSurfaces& surfaces, const CutPlanes& planes);

}  // namespace pomona
