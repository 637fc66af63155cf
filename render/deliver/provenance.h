// The program and seeds that made a file, as the file states them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "generator/order/order.h"

namespace pomona {

struct Provenance {
  std::vector<std::uint64_t> seeds = {0};  ///< seeds of the fruit, of fruits side by side, or of the scene
};

/// The provenance of fruits with the order's own seeds.
Provenance provenance_of(const FruitOrder& fruit);

/// "pomona 0.6.0, seed 7", "pomona 0.6.0, seeds 1-2". Without paths and times: the same seed gives the same bytes.
std::string made_by(const Provenance& provenance);

}  // namespace pomona
