// The layers of ground truth: for each pixel the instance, the part, the organ, the depth and the normal.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "generator/base/parallel.h"
#include "render/truth/naming.h"

namespace pomona {

/// One entry per pixel, row by row from the top left, at the pixel's middle.
struct TruthLayers {
  int width = 0, height = 0;
  std::vector<std::uint16_t> instance;  ///< numbers as in TruthNaming; 0 where paper or ground shows
  std::vector<std::uint16_t> fruit;
  std::vector<std::uint16_t> part;
  std::vector<std::uint16_t> organ;   ///< Organ::instance; 0: the fruit itself
  std::vector<float> depth;           ///< metres along the line of sight of the picture's middle; 0 where nothing is
  std::vector<glm::vec3> normal;      ///< unit, in the scene's frame, as the mesh interpolates it; (0, 0, 0) likewise
  std::vector<std::uint8_t> section;  ///< 1 where a cut face shows

  std::size_t pixel(int x, int y) const { return static_cast<std::size_t>(y) * width + x; }
};

/// The layers of the scene's view, with the same projection as its strokes. The part is that of the vertex with the
/// largest barycentric coordinate. Open solids show both sides; their normals point to the eye.
TruthLayers truth_layers(const Scene& scene, const TruthNaming& names, int width, int height, Threads threads = {});

}  // namespace pomona
