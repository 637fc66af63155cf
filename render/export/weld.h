// The pieces of a cut fruit joined again, as strongly as what they share of a cut face.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/piece/contacts.h"

namespace pomona {

struct Weld {
  PieceContact contact;
  double strength = 0;  ///< newtons: the area of each part's share times its tissue's strength
};

/// A weld for each contact.
std::vector<Weld> welds_of(std::span<const Solid> pieces);

/// "weld_1_2_cut_0": the pieces, counted from 1, and the number of the cut face.
std::string weld_name(const PieceContact& contact);

}  // namespace pomona
