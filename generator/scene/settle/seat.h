// The last fraction of a millimetre: piled pieces moved until their real meshes touch without overlap.
#pragma once

#include <span>
#include <vector>

#include "generator/base/parallel.h"
#include "generator/scene/settle/real_contact.h"

namespace pomona {

struct SeatOptions {
  double overlap = 0.01;   ///< shares of a piece's size: overlaps below this stay
  double touch = 0.001;    ///< a distance below this is contact
  double farthest = 0.03;  ///< how far a piece may sink to reach its support
  int rounds = 24;
};

/// Pushes overlapping pieces apart, then lets each, from the lowest up, sink straight down until it touches.
/// Returns the pieces' new places; the stand does not move.
std::vector<glm::dvec3> seat(std::vector<PlacedMesh> pieces, const PlacedMesh& stand, const SeatOptions& options = {},
                             Threads threads = {});

}  // namespace pomona
