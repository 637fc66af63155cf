// Random points on spheres, without trigonometry.
#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

#include "generator/base/random.h"

namespace pomona {

/// Random numbers of a stream, from a position on.
class Draws {
 public:
  Draws(const RandomStream& stream, std::uint64_t first) : stream_(stream), next_(first) {}

  /// Uniform in [0, 1).
  double uniform() { return stream_.uniform(next_++); }

  /// A point of the open unit disc without its middle, and its squared distance from the middle.
  struct InDisc {
    double x = 0, y = 0, squared = 0;
  };
  InDisc in_disc();

 private:
  const RandomStream& stream_;
  std::uint64_t next_;
};

/// Uniform over the unit sphere [Marsaglia 1972].
glm::dvec3 random_direction(Draws& draws);

/// The corners of a randomly rotated icosahedron: each is uniform over the sphere, and together they give the mean over
/// it of every polynomial of degree 5.
std::array<glm::dvec3, 12> random_icosahedron(Draws& draws);

/// The place where a random walk that starts at `outside` first meets the sphere of `radius` around 0, given that it
/// does (it escapes to infinity with probability 1 - radius / distance).
glm::dvec3 random_return(const glm::dvec3& outside, double radius, Draws& draws);

}  // namespace pomona
