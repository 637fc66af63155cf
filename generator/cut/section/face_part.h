// The part of a section on one cut face: duplicate vertices where surfaces pass through the face, one for each side,
// with the colours of the sides (paper, section 3.2, Figure 3c).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "generator/cut/section/cross_section.h"
#include "generator/cut/section/face.h"
#include "generator/cut/section/regions.h"
#include "generator/cut/section/split_mesh.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// A triangle of the section that closes pieces.
struct Cap {
  std::array<std::uint32_t, 3> point{};  ///< of the split mesh; representatives (same_as)
  Regions::Closing closing;
};

/// Duplicate vertices, one for each fan of triangles between cut segments, numbered from 0.
struct FacePart {
  struct Vertex {
    std::uint32_t point = 0;  ///< of the split mesh; a representative (same_as)
    Color color{0};           ///< linear
    std::int32_t part = 0;    ///< of the fruit
    bool interior = false;    ///< its colour comes later, by diffusion
  };
  std::vector<Vertex> vertex;
  std::vector<CutFace> frame;  ///< one for each facet that has triangles

  // Per triangle; a triangle that closes several parts is stored several times.
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint32_t> frame_of;
  std::vector<std::array<glm::vec3, 3>> normal;  ///< of its corners
  std::vector<Cap> cap;

  std::vector<SectionSegment> segments;
};

/// The part of the section on the face. Parts of several faces may be made in parallel.
FacePart part_of(const Face& face, const Regions& regions, const SplitMesh& mesh, const DiffusionSurfaces& surfaces);

}  // namespace pomona
