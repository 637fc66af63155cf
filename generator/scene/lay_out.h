// Lays pieces out on the table, for a picture that shows their cut faces.
#pragma once

#include "generator/scene/scene.h"

namespace pomona {

/// Strips of peel hang in pictures; for simulators they keep the shape, and the mass, that they were cut in.
enum class Peels { hang, as_cut };

/// The instances of `scene` in rows on the ground, without contact, each in its table_pose(). The view is from
/// eye_over_table(), or from eye_beside_table() if most of the fruit stands as it grew. The number of rows is the one
/// that fills the picture best. If most pieces are slender, they lie in their rows like the strokes of ////. Peels in
/// one strip hang (hanging_peel.h) beside the peeled fruit, which stands as it grew. \param aspect the picture's width
/// over its height.
Scene laid_out(const Scene& scene, double aspect = 4.0 / 3, Peels peels = Peels::hang);

/// The pieces of one fruit without those that are specks beside the others in a row: below 1/2500 of all together, and
/// below a twentieth of the mean. Their solids stay; they have no instance. Open pieces, whose volume says little,
/// stay.
Scene without_crumbs(Scene pieces);

}  // namespace pomona
