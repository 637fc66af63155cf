// Sample points spread over a surface, in a tree of balls: contacts are looked for at these points.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace pomona {

/// A node of the tree. Balls are stored in depth-first order: a ball stands before those that it contains.
struct SampleBall {
  glm::vec3 center{0};  ///< metres
  float radius = 0;     ///< metres
  int first = 0;        ///< index of its first point
  int count = 0;        ///< number of its points; 0 for a ball that contains other balls
  int after = 0;        ///< index of the first ball behind those that it contains
};

struct SurfaceSamples {
  std::vector<glm::vec3> point;  ///< metres
  std::vector<SampleBall> ball;  ///< the tree, root first
};

struct SampleOptions {
  double along_edges = 0;         ///< distance between points on sharp edges, metres
  double elsewhere = 0;           ///< distance between points on the rest of the surface, metres
  std::size_t max_points = 4000;  ///< the distances grow where there would be more points
};

/// Samples of a welded mesh: its vertices, the centres of its triangles and of its sharp edges, thinned out evenly.
SurfaceSamples surface_samples(std::span<const glm::dvec3> position, std::span<const glm::uvec3> triangle,
                               SampleOptions options);

}  // namespace pomona
