// Faults of settled pieces, and whether they can be accepted.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "generator/scene/settle/fit_check.h"
#include "generator/scene/settle/settle_options.h"

namespace pomona {

/// A fault of one piece.
struct Fault {
  std::size_t piece = 0;  ///< index of the piece
  std::string what;       ///< the end of a sentence that starts with the piece's name
  bool is_severe = true;  ///< it is never accepted
};

/// The fault of a piece; nothing if it fits well.
std::optional<Fault> fault_of(std::size_t piece, const Fit& fit, const SettleOptions& options);

/// Whether no fault is severe, and their share of all pieces is small.
bool are_acceptable(const std::vector<Fault>& faults, std::size_t pieces, const SettleOptions& options);

/// \throws Error (some_items_failed), always. It names the first few faults; its place is that of the first item.
[[noreturn]] void give_up(const std::vector<Fault>& faults, std::span<const SettleItem> items);

}  // namespace pomona
