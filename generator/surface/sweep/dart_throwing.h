// Places for grains, by dart throwing [Cook 1986; paper, section 4, step 2] with a spacing that may vary over the
// surface.
#pragma once

#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/surface/sweep/grain_pose.h"
#include "generator/surface/sweep/grain_targets.h"

namespace pomona {

/// A place taken, and the grain there.
struct Dart : GrainSeat {
  double spacing = 0;  ///< metres: the Poisson radius over the square root of the density there
  GrainPose pose;
};

/// About how many grains the targets have room for: the integral of 0.7 density / radius^2, or a little more.
double room_for_grains(const std::vector<GrainTarget>& targets, const GrainSketch& sketch);

/// Candidates spread over the targets by their density are taken one by one; each stays unless an earlier one
/// that faces the same way (or any, if the sketch says so), or one of `others`, has its centre nearer than the
/// mean of both spacings; or, if the grains are solid, its ellipsoid in the way.
/// Uses draws 0 to 5 of each candidate's places. The same for any number of threads.
std::vector<Dart> thrown_darts(std::vector<GrainTarget> targets, const GrainSketch& sketch, const GrainDraws& draws,
                               Threads threads, std::span<const Dart> others = {});

}  // namespace pomona
