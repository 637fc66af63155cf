// Blocks with random rotations, and planes along their faces.
#pragma once

#include <cstdint>
#include <vector>

#include "generator/base/random.h"
#include "generator/knife/knife.h"
#include "generator/surface/diffusion_surfaces.h"

namespace pomona::oracle {

struct BlockCut {
  DiffusionSurfaces block;
  std::vector<Knife> knives;
  double volume = 0;  ///< the block's, cubic metres
};

/// A block of random size, place and rotation, and planes along two to six of its faces. All planes are moved out or in
/// equally far: not at all, by less than 1e-10 m, or by up to 1e-7 m. Planes of every other block are also tilted, by
/// as much at the block's rim.
BlockCut turned_block_cut(const RandomStream& random, std::uint64_t number);

/// Faults of the pieces of such a cut.
struct BlockFaults {
  int open = 0;             ///< pieces that are open
  int without_volume = 0;   ///< pieces whose volume is not above 0
  double volume_error = 0;  ///< of all pieces together, share of the whole
};

BlockFaults faults_of(const BlockCut& task);

}  // namespace pomona::oracle
