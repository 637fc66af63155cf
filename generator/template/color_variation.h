// How much individuals differ in colour.
#pragma once

#include <vector>

namespace pomona {

/// Standard deviations, in OKLab for a colour of chroma 0.25 (greyer ones change hue and chroma less).
struct ColorVariation {
  double all = 0;             ///< of one draw for all parts
  std::vector<double> parts;  ///< of a draw for each part; empty = none
  double ripeness = 0;        ///< of the ripeness about 1

  bool declared() const { return all > 0 || !parts.empty() || ripeness > 0; }
};

}  // namespace pomona
