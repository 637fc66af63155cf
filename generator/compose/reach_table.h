// How far a body reaches from its heart in every direction.
#pragma once

#include <array>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "generator/surface/diffusion_surfaces.h"

namespace pomona {

/// Tabled over the six faces of a cube, linear between.
class ReachTable {
 public:
  /// \param skin index into surface_names of the surfaces
  ReachTable(const DiffusionSurfaces& surfaces, std::int32_t skin, const glm::dvec3& heart);

  const glm::dvec3& heart() const { return heart_; }

  /// From the heart to the skin along a direction of any length; the farthest place where there are several.
  double along(const glm::dvec3& direction) const;

  double farthest() const { return farthest_; }

  /// False if some direction never meets the skin: the heart lies outside, or the skin is open.
  bool is_closed() const { return closed_; }

  /// Second moments of the skin's vertices about the heart.
  const glm::dmat3& spread() const { return spread_; }

 private:
  static constexpr int cells = 20;  // along an edge of the cube
  static constexpr int nodes = cells + 1;
  using Face = std::array<double, static_cast<std::size_t>(nodes) * nodes>;

  void add(const std::array<glm::dvec3, 3>& corner, int face);

  glm::dvec3 heart_;
  std::array<Face, 6> reach_{};
  double farthest_ = 0;
  bool closed_ = true;
  glm::dmat3 spread_{0};
};

}  // namespace pomona
