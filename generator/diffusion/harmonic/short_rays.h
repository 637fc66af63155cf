// What a point sees of the surfaces in its cell, along rays to the cell's corners.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "generator/diffusion/harmonic/quad.h"

namespace pomona {

/// One triangle's corners, in cells, relative to the point that looks.
struct SeenTriangle {
  glm::vec3 a, b, c;
};

/// Where a ray ends on a surface.
struct ShortRayHit {
  float fraction = 0;          ///< of the way
  std::uint32_t triangle = 0;  ///< as numbered by the caller
  glm::vec3 weight{0};         ///< barycentric
  bool sees_front = true;
};

/// Eight rays from one point to the corners of the unit cell around it; corner k lies at bits 0, 1, 2 of k.
class ShortRays {
 public:
  /// `low` is the cell's low corner as the point sees it: -1 to 0 along each axis.
  explicit ShortRays(const glm::vec3& low);

  /// Shortens the rays that this triangle meets. Neighbours that share an edge leave no gap between them.
  void meet(const SeenTriangle& triangle, std::uint32_t number);

  /// Nothing if ray k is free.
  std::optional<ShortRayHit> hit(int k) const;

  glm::vec3 towards(int k) const { return {across_[0][k & 1], across_[1][k >> 1 & 1], across_[2][k >> 2]}; }

 private:
  /// Four rays towards low z, then four towards high z.
  struct Four {
    Quad fraction, weight_a, weight_b;
    std::array<std::uint32_t, 4> triangle{};
    std::array<bool, 4> sees_front{};
  };
  std::array<std::array<float, 2>, 3> across_;
  std::array<Four, 2> four_;
};

}  // namespace pomona
