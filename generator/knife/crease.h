// What counts as a crease of a cutting surface.
#pragma once

namespace pomona {

/// The cosine of 40 degrees: where two facets' normals are no farther apart, the surface is taken as smooth. A crinkle
/// turns by 33 degrees at its crests.
constexpr double smooth_cosine = 0.766;

}  // namespace pomona
