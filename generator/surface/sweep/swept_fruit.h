// A swept fruit with the spots that its sweep finds, which are looked for once.
#pragma once

#include <vector>

#include "generator/surface/diffusion_surfaces.h"
#include "generator/surface/sweep/spot.h"
#include "generator/surface/sweep/sweep_options.h"
#include "generator/template/template.h"

namespace pomona {

struct SweptFruit {
  DiffusionSurfaces surfaces;  ///< as sweep() gives them
  std::vector<Spot> raised;    ///< of all surfaces, as raised_spots() gives them
};

/// \throws Error as sweep() (sweep.h) does.
SweptFruit swept_fruit(const Template& fruit, const SweepOptions& options = {});

}  // namespace pomona
