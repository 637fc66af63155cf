// Which part fills which room inside a fruit, as far as its surfaces enclose it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// What closed surfaces enclose. A place belongs to the smallest region around it: the kernel lies in the stone, the
/// stone in the flesh. Open surfaces, septa for one, enclose nothing, and walls of cavities enclose air.
struct PartRegions {
  struct Region {
    std::int32_t part = 0;             ///< that fills it: what most of its surface, by area, has on its inner side
    double volume = 0;                 ///< cubic metres
    std::size_t first = 0, count = 0;  ///< its triangles
  };
  std::vector<Region> region;        ///< the smallest first
  std::vector<glm::uvec3> triangle;  ///< counter-clockwise seen from outside; of `position`
  std::vector<glm::vec3> position;
  std::vector<std::string> part_names;
};

/// \param surfaces as swept and strewn, blur not split: the border lies in the middle of the blur.
PartRegions part_regions(const DiffusionSurfaces& surfaces);

}  // namespace pomona
