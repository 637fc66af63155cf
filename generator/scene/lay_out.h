// Pieces laid out on the table, for a picture that shows their cut faces.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// The instances of `scene` in rows on the ground, none touching another, each turned so that its cut faces
/// look up and towards +Z; seen from there. Whole fruits keep their axis upright.
Scene laid_out(const Scene& scene);

}  // namespace pomona
