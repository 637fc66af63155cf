// Points spread over a surface, in a tree of balls: where a piece is asked whether it touches another.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A ball around the points [first, first + count) of some samples. Balls stand before those they hold; all that the
/// ball holds ends before ball `after`. An inner ball has a count of 0.
struct SampleBall {
  glm::vec3 center{0};
  float radius = 0;
  int first = 0, count = 0;
  int after = 0;
};

struct SurfaceSamples {
  std::vector<glm::vec3> point;  ///< metres
  std::vector<SampleBall> ball;
};

struct SampleOptions {
  double along_edges = 0;  ///< metres between points on sharp edges,
  double elsewhere = 0;    ///< and on the rest of the surface; wider where that makes too many
  std::size_t most = 4000;
};

/// Vertices, centres of triangles and of sharp edges of a welded mesh, thinned out evenly.
SurfaceSamples surface_samples(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle,
                               SampleOptions options);

}  // namespace pomona
