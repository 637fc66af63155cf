// What a cut has made of a piece, in a cook's words: for labels of data sets.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "generator/piece/solid.h"

namespace pomona {

enum class CutState : std::uint8_t {
  whole,
  half,
  quarter,
  wedge,
  slice,
  dice,
  stick,
  peel,  ///< what a peeler takes away
  piece  ///< anything else
};

/// "wedge"
std::string_view name_of(CutState state);

/// Whether this knife, as the user wrote it, is a peeler.
bool is_peeler(std::string_view knife);

/// The state that knives give, as the user wrote them: the last one that is no peeler decides, but for `half` and
/// `across`, two of which make quarters. None leave the fruit whole.
CutState state_by(std::span<const std::string> knives);

/// The states that pieces of a fruit cut like this may have: that of the knives, and peel.
std::vector<CutState> states_by(std::span<const std::string> knives);

struct PieceState {
  CutState state = CutState::whole;
  bool peeled = false;  ///< a peeler took its skin
};

/// Peel is what a peeler has cut and skin covers at least a fifth of.
PieceState state_of(const Solid& solid);

}  // namespace pomona
