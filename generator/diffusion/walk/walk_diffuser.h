// True diffusion by walks on spheres: slow, with a known standard error.
#pragma once

#include "generator/diffusion/diffuser.h"
#include "generator/diffusion/walk/walk_on_spheres.h"

namespace pomona {

/// The standard error in 1/255: 4, 1 or 0.3.
double standard_error_of(Quality quality);

/// Colours are harmonic: off the surfaces, each is the mean of those around it. The paper compares its method with
/// this, "solving the Poisson equation" [Figure 4]. The progress of a batch counts the points of all its fruits. Same
/// bits for any number of threads and on any x86-64.
/// \throws Error (usage) unless the standard error to reach is above 0.
std::unique_ptr<Diffuser> make_walk_diffuser(const WalkOptions& options = {});

}  // namespace pomona
