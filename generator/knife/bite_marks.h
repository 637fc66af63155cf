// What a mouth takes out of a fruit.
#pragma once

#include "generator/mesh/closed_surface.h"

namespace pomona {

/// A bite of this width (metres) about the origin: +Y goes into the fruit, +Z is up. Two rows of teeth have left their
/// grooves, those above broader than those below; each row fans out from beyond the middle, and the rows
/// meet in a ridge. No tooth is quite like the next, but the same width always has the same teeth. It is four fifths as
/// high as wide, and as deep. The surface is closed, and every ray from the origin meets it once.
ClosedSurface bite_marks(double width);

}  // namespace pomona
