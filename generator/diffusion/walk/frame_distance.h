// Distances from a point to eight triangles at once, by vector instructions chosen at run time.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "generator/diffusion/walk/triangle_frames.h"

namespace pomona {

/// Squared distances to the triangles of a group, normalised; exact within 1e-6 of the distances. The bits do not
/// depend on the width of vectors.
using GroupDistances = std::array<float, FrameGroup::size>;
GroupDistances squared_distances(const FrameGroup& group, const glm::vec3& point);

/// A group, and a lower bound of its distance.
struct NearGroup {
  float distance = 0;
  std::uint32_t group = 0;
};

/// The minimum of squared_distances() over `count` groups in order of `near[i].distance`; it stops where these exceed
/// `reach` plus the distance found.
float min_squared_distance(const FrameGroup* groups, const NearGroup* near, std::size_t count, float reach,
                           const glm::vec3& point);

}  // namespace pomona
