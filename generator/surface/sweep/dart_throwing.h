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

/// The number of grains for which the targets have room, about: the integral of 0.7 density / radius^2, or a little
/// more.
double room_for_grains(const std::vector<GrainTarget>& targets, const GrainSketch& sketch);

/// Dart throwing. Candidates are spread over the targets by density and tested one by one. A candidate is rejected if
/// an earlier grain that faces the same direction (or any grain, if the sketch says so), or one of `others`, is nearer
/// than the mean of both spacings; or, if the grains are solid, if their ellipsoids overlap. Uses random numbers 0 to 5
/// of each candidate. The result is the same for any number of threads.
std::vector<Dart> thrown_darts(std::vector<GrainTarget> targets, const GrainSketch& sketch, const GrainDraws& draws,
                               Threads threads, std::span<const Dart> others = {});

}  // namespace pomona
