// Positive mean value diffusion on the CPU [Lipman et al. 2007; paper, section 3.2].
#pragma once

#include "generator/diffusion/diffuser.h"

namespace pomona {

struct PmvcOptions {
  Quality quality = Quality::final;
  Threads threads;
};

/// f(x) = integral of c / d over the sphere of directions, divided by that of 1 / d, where d is the distance
/// to the first surface in a direction and c the colour of the side seen; directions that hit nothing count
/// in neither. Same bits for any number of threads and on any x86-64.
std::unique_ptr<Diffuser> make_pmvc_diffuser(const PmvcOptions& options = {});

}  // namespace pomona
