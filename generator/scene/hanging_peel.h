// A peel that has come off in one strip, as it hangs from a hand: for pictures.
#pragma once

#include <optional>

#include "generator/piece/solid.h"

namespace pomona {

/// A piece that winds about the fruit's axis one and a half times or more, its turns drawn apart like those of a
/// spring: the more, the more of it hangs below, and the lower end swinging out a little. Each place goes where the
/// strip does that goes through it, so that turns keep their width, their bend and, but for the swing, their volume;
/// ends in which turns hang together stay as they are. Nothing for any other piece.
std::optional<Solid> hanging_peel(const Solid& solid);

}  // namespace pomona
