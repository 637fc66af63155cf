// What is wrong with settled pieces, and what may pass.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/scene/settle/settle.h"

namespace pomona {

/// What is wrong with a piece.
struct Fault {
  std::size_t piece = 0;
  std::string what;
  bool is_grave = true;  ///< not even one in many may have it
};

/// Nothing if the piece fits well.
std::optional<Fault> fault_of(std::size_t piece, const Fit& fit, const SettleOptions& options);

/// Whether faults are so small and so few of all pieces that they may stay.
bool may_pass(const std::vector<Fault>& faults, std::size_t pieces, const SettleOptions& options);

/// \throws Error (some_items_failed) that names the first of them, at the place of what asks for the first.
[[noreturn]] void give_up(const std::vector<Fault>& faults, std::span<const SettleItem> items);

}  // namespace pomona
