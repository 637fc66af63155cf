// The surface of a bite, with the marks of teeth.
#pragma once

#include "generator/mesh/closed_surface.h"

namespace pomona {

/// A bite around the origin: +Y points into the fruit, +Z is up. Its height and its depth are four fifths of its width.
/// Two rows of teeth have left grooves; the upper ones are broader. Each row fans out from a point beyond the middle,
/// and the rows meet in a ridge. No two teeth are equal, but the same width always gives the same teeth. The surface is
/// closed, and every ray from the origin meets it once. \param width metres
ClosedSurface bite_marks(double width);

}  // namespace pomona
