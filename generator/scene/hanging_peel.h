// A peel in one strip as it hangs from a hand, for pictures.
#pragma once

#include <optional>

#include "generator/piece/solid.h"

namespace pomona {

/// A piece that winds about the fruit's axis at least one and a half times: its turns are pulled apart like those of a
/// spring. A turn with more weight below it is pulled more, and the lower end swings out a little. Each point moves
/// with its turn, so that turns keep their width, their bend and, except for the swing, their volume. Ends where turns
/// are connected do not change. Nothing for any other piece.
std::optional<Solid> hanging_peel(const Solid& solid);

}  // namespace pomona
