// True diffusion: Laplace's equation in the volume, solved on a grid (what the paper, section 3.2, held to be too
// dear).
#pragma once

#include "generator/diffusion/diffuser.h"
#include "generator/diffusion/harmonic/harmonic_options.h"

namespace pomona {

/// The harmonic function with the colours of the surfaces' sides as its values there; where a random walk may escape
/// to infinity without meeting a surface, its mean over the walks that do not. Same bits for any number of threads
/// and on any x86-64. Outside surfaces that seal everything off, the nearest side gives the colour.
std::unique_ptr<Diffuser> make_harmonic_diffuser(const HarmonicOptions& options = {});

}  // namespace pomona
