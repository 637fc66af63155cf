// One cut face's share of a section: duplicate vertices where surfaces pass through it, one for each side, with the
// colours of the sides (paper, section 3.2, Figure 3c).
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

/// A triangle of the section as pieces see it.
struct Cap {
  std::array<std::uint32_t, 3> point{};  ///< of the split mesh, those that stand for their places
  Regions::Closing closing;
};

/// Duplicate vertices, one for each fan of triangles between cut segments, numbered from 0.
struct FacePart {
  struct Vertex {
    std::uint32_t point = 0;  ///< of the split mesh, the one that stands for its place
    Color color{0};           ///< linear
    std::int32_t part = 0;    ///< of the fruit
    bool interior = false;    ///< still to be diffused
  };
  std::vector<Vertex> vertex;
  std::vector<CutFace> frame;  ///< one for each facet that has triangles

  // Per triangle; one that closes several parts stands there several times.
  std::vector<glm::uvec3> triangle;
  std::vector<std::uint32_t> frame_of;
  std::vector<std::array<glm::vec3, 3>> normal;  ///< of its corners
  std::vector<Cap> cap;

  std::vector<SectionSegment> segments;
};

/// What of the face is section. Parts of several faces may be made at the same time.
FacePart part_of(const Face& face, const Regions& regions, const SplitMesh& mesh, const DiffusionSurfaces& surfaces);

}  // namespace pomona
