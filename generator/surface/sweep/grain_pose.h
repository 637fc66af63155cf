// How a grain lies, and how large it is.
#pragma once

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

#include "generator/base/random.h"
#include "generator/template/grain_sketch.h"

namespace pomona {

/// The draws of one kind of grains in one variant; no other kind's depend on them.
struct GrainDraws {
  RandomStream places;  ///< eight to each candidate; which stay, and how they lie
  RandomStream looks;   ///< eight to each candidate: what was added since
  RandomStream folds;   ///< one to each fold
};

GrainDraws grain_draws(VariantKey key, const std::string& name);

constexpr std::uint64_t draws_per_candidate = 8;

/// Where one grain sits.
struct GrainSeat {
  glm::dvec3 center{0};
  glm::dvec3 normal{0};      ///< unit, away from the side the grain sits on
  glm::dvec3 tangent{0};     ///< unit, across the normal, up the vertical curve
  std::uint64_t number = 0;  ///< of the candidate: what its draws are keyed by
};

/// The grain there: its half axes, and which of the sketch's looks it has.
struct GrainPose {
  static constexpr int own_look = -1;

  glm::dvec3 thickness{0}, length{0}, width{0};  ///< right-handed in this order; the tip is at +length
  int look = own_look;
};

GrainPose grain_pose(const GrainSketch& sketch, const GrainSeat& seat, const GrainDraws& draws);

/// True if the ellipsoids with these half axes share a point within [Perram and Wertheim 1985].
bool ellipsoids_overlap(const glm::dvec3& center, const GrainPose& pose, const glm::dvec3& other_center,
                        const GrainPose& other);

}  // namespace pomona
