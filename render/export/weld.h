// The pieces of a cut fruit joined again, as strongly as what they share of a cut face or around a spared part.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "generator/piece/contacts.h"

namespace pomona {

struct Weld {
  PieceContact contact;
  std::map<std::int32_t, double> parts;  ///< the contact's area by part, square metres: of two parts, what gives way
  double strength = 0;                   ///< newtons: the area of each part's share times its tissue's strength
};

/// A weld for each contact.
std::vector<Weld> welds_of(std::span<const Solid> pieces);

/// "weld_1_2_cut_0": the pieces, counted from 1, and the number of the cut face; "weld_1_2_spared" around a spared
/// part.
std::string weld_name(const PieceContact& contact);

}  // namespace pomona
