// Layers around the axis, one within the other, that must not cross.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/layer_gap.h"

namespace pomona {

/// The layers of a drawing by how far out they lie, and what keeps any two apart.
struct Layers {
  std::vector<std::size_t> surface;        ///< index into Template::surfaces, outermost first
  std::vector<std::vector<LayerGap>> gap;  ///< [i][j]: what keeps layer i from crossing layer j
};

/// The layers of all surfaces around the axis that have a loop.
Layers layers_of(const Template& fruit);

/// Swells that keep the layers apart: each is drawn towards the swell of the next one outside as far as it must,
/// and gradually around the place where it must. swells[i] belongs to layer i, at azimuths common to all.
/// Layers marked `fixed` do not move.
std::vector<std::vector<double>> kept_apart(const Layers& layers, std::vector<std::vector<double>> swells,
                                            const std::vector<bool>& fixed);

/// True if no two layers cross at any of the azimuths.
bool are_apart(const Layers& layers, const std::vector<std::vector<double>>& swells);

}  // namespace pomona
