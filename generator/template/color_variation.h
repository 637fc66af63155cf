// The variation of colour between individuals.
#pragma once

#include <vector>

namespace pomona {

/// Standard deviations, in OKLab for a colour of chroma 0.25 (greyer ones change hue and chroma less).
struct ColorVariation {
  double all = 0;             ///< of a random shift that all parts share
  std::vector<double> parts;  ///< of a random shift of each part; empty = none
  double ripeness = 0;        ///< of the ripeness, whose mean is 1

  /// Parts that are one tissue: they all change colour by as much as the first of their list does. No part is in two.
  std::vector<std::vector<int>> tissues = {};

  bool declared() const { return all > 0 || !parts.empty() || ripeness > 0; }
};

}  // namespace pomona
