// The pose and the size of a grain.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>

#include <glm/vec3.hpp>

#include "generator/base/random.h"
#include "generator/template/grain_sketch.h"

namespace pomona {

/// The random numbers of one kind of grains in one variant. Other kinds have their own.
struct GrainDraws {
  RandomStream places;  ///< eight numbers for each candidate: its position, and its pose
  RandomStream looks;   ///< eight numbers for each candidate: its appearance
  RandomStream folds;   ///< one number for each fold
};

GrainDraws grain_draws(VariantKey key, const std::string& name);

constexpr std::uint64_t draws_per_candidate = 8;

/// The place of a grain.
struct GrainSeat {
  glm::dvec3 center{0};
  glm::dvec3 normal{0};      ///< unit, away from the side on which the grain sits
  glm::dvec3 tangent{0};     ///< unit, perpendicular to the normal, up along the vertical curve
  std::uint64_t number = 0;  ///< number of the candidate: it selects the random numbers
  double along = 0;          ///< share of the surface's vertical curve
};

/// The pose of a grain: its half axes, and the index of its appearance in the sketch.
struct GrainPose {
  static constexpr int own_look = -1;

  glm::dvec3 thickness{0}, length{0}, width{0};  ///< right-handed in this order; the tip is at +length
  int look = own_look;
};

GrainPose scaled(GrainPose pose, double factor);

/// The shortest and the longest half axis.
double min_radius(const GrainPose& pose);
double max_radius(const GrainPose& pose);

/// The first of the wishes that is not almost along `axis`, made perpendicular to it.
glm::dvec3 across(const glm::dvec3& axis, std::initializer_list<glm::dvec3> wishes);

/// The appearance of the grain with this number.
int drawn_look(const GrainSketch& sketch, std::uint64_t number, const GrainDraws& draws);

GrainPose grain_pose(const GrainSketch& sketch, const GrainSeat& seat, const GrainDraws& draws);

/// True if the ellipsoids with these half axes share a point within [Perram and Wertheim 1985].
bool ellipsoids_overlap(const glm::dvec3& center, const GrainPose& pose, const glm::dvec3& other_center,
                        const GrainPose& other);

}  // namespace pomona
