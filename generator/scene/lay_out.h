// Pieces laid out on the table, for a picture that shows their cut faces.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// The instances of `scene` in rows on the ground, none touching another, each as table_pose() lays it; seen by
/// eye_over_table(), or by eye_beside_table() where most of the fruit stands as it grew. Rows are as many as fill the
/// picture best; where most pieces are slender, they lie in their rows like the strokes of ////.
/// Peels that came off in a strip hang, as hanging_peel() has them, beside what was peeled as it grew.
/// \param aspect the picture's width over its height.
Scene laid_out(const Scene& scene, double aspect = 4.0 / 3);

}  // namespace pomona
