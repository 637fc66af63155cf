// Layers around the axis, one within the other, that must not cross.
#pragma once

#include <vector>

#include "generator/template/template.h"
#include "generator/variation/profile_gap.h"

namespace pomona {

/// The layers of a drawing by how far out they lie, and how much any two may differ. Shapes are logs of loop
/// radius over reference radius, at azimuths common to all layers; shapes[i] belongs to surface[i].
struct Layers {
  std::vector<std::size_t> surface;            ///< index into Template::surfaces, outermost first
  std::vector<std::vector<LogRange>> allowed;  ///< [i][j]: of shape i less shape j
};

/// The layers of all surfaces around the axis that have a loop.
Layers layers_of(const Template& fruit);

/// Shapes that keep to the allowed ranges: each layer is drawn towards the shape of the next one outside as far as it
/// must, the more gradually the wider the neighbourhood. Layers marked `fixed` do not move.
std::vector<std::vector<double>> kept_apart(const Layers& layers, std::vector<std::vector<double>> shapes,
                                            const std::vector<bool>& fixed);

}  // namespace pomona
