// Casts rays from a point to the corners of its cell, against the surfaces in the cell.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/vec3.hpp>

#include "generator/diffusion/harmonic/quad.h"

namespace pomona {

/// One triangle's corners, in cells, relative to the origin of the rays.
struct SeenTriangle {
  glm::vec3 a, b, c;
};

/// The hit of a ray on a surface.
struct ShortRayHit {
  float fraction = 0;          ///< share of the ray's length
  std::uint32_t triangle = 0;  ///< the caller's number
  glm::vec3 weight{0};         ///< barycentric coordinates of the hit
  bool sees_front = true;      ///< the ray hits the front of the triangle
};

/// Eight rays from one point to the corners of the unit cell around it. Bits 0, 1, 2 of k give the x, y, z of corner k.
class ShortRays {
 public:
  /// \param low the cell's low corner relative to the point: -1 to 0 along each axis.
  explicit ShortRays(const glm::vec3& low);

  /// Shortens the rays that this triangle meets. Two triangles that share an edge leave no gap.
  void meet(const SeenTriangle& triangle, std::uint32_t number);

  /// The hit of ray k; nothing if the ray reaches its corner.
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
