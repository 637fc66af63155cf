// Four floats at once: red, green, blue, and the chance that a walk from here ends on a surface at all.
#pragma once

namespace pomona {

/// A built-in vector of gcc and clang. The lanes never meet, so the bits are those of four plain floats.
using Quad = float __attribute__((vector_size(16)));

}  // namespace pomona
