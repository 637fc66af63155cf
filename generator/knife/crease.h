// The angle from which an edge of a cutting surface is a crease.
#pragma once

namespace pomona {

/// The cosine of 40 degrees. The surface is smooth where the normals of two facets differ by at most this angle. A
/// crinkle turns by 33 degrees at its crests.
constexpr double smooth_cosine = 0.766;

}  // namespace pomona
