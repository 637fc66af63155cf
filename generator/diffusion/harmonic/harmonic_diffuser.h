// True diffusion: Laplace's equation in the volume, solved on a grid. The paper (section 3.2) avoids it as too slow.
#pragma once

#include "generator/diffusion/diffuser.h"
#include "generator/diffusion/harmonic/harmonic_options.h"

namespace pomona {

/// The harmonic function whose values on the surfaces are the colours of their sides. Where a random walk may escape to
/// infinity without meeting a surface, it is the mean over the walks that do not escape. The result has the same bits
/// for any number of threads and on any x86-64. Outside closed surfaces, the nearest side gives the colour.
std::unique_ptr<Diffuser> make_harmonic_diffuser(const HarmonicOptions& options = {});

}  // namespace pomona
