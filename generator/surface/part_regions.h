// The regions inside a fruit that closed surfaces enclose, and the part that fills each.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// The regions. A point belongs to the smallest region around it: the kernel is inside the stone, the stone inside the
/// flesh. Open surfaces, such as septa, enclose nothing; walls of cavities enclose air.
struct PartRegions {
  struct Region {
    std::int32_t part = 0;             ///< the part that fills it: that on the inner side of most of its surface, by
                                       ///< area
    double volume = 0;                 ///< cubic metres
    std::size_t first = 0, count = 0;  ///< its triangles are triangle[first] to triangle[first + count - 1]
  };
  std::vector<Region> region;        ///< the smallest first
  std::vector<glm::uvec3> triangle;  ///< counter-clockwise seen from outside; of `position`
  std::vector<glm::vec3> position;
  std::vector<std::string> part_names;
};

/// \param surfaces with grains, before sheets(): the border of a region lies in the middle of the blur.
PartRegions part_regions(const DiffusionSurfaces& surfaces);

}  // namespace pomona
