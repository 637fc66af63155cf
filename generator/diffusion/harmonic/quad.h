// Four floats at once: red, green, blue, and the probability that a random walk from here ends on a surface.
#pragma once

namespace pomona {

/// A built-in vector of gcc and clang. The lanes do not interact, so the bits are those of four plain floats.
using Quad = float __attribute__((vector_size(16)));

}  // namespace pomona
