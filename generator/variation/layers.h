// Layers around the axis, one inside the other, that must not cross.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/layer_gap.h"

namespace pomona {

/// The layers of a drawing, from outside to inside, and the gaps between any two.
struct Layers {
  std::vector<std::size_t> surface;        ///< index into Template::surfaces, outermost first
  std::vector<std::vector<LayerGap>> gap;  ///< [i][j]: the condition under which layer i does not cross layer j
};

/// The layers of all surfaces around the axis that have a loop.
Layers layers_of(const Template& fruit);

/// Swells with which the layers do not cross: each swell moves towards that of the next layer outside as far as
/// necessary, with a gradual change around such places. swells[i] belongs to layer i; the azimuths are the same for all
/// layers. Layers marked `fixed` do not move.
std::vector<std::vector<double>> kept_apart(const Layers& layers, std::vector<std::vector<double>> swells,
                                            const std::vector<bool>& fixed);

/// True if no two layers cross at any of the azimuths.
bool are_apart(const Layers& layers, const std::vector<std::vector<double>>& swells);

}  // namespace pomona
