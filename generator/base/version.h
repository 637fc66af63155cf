// The program's version, from CMakeLists.txt.
#pragma once

namespace pomona {

extern const char version[];  ///< "0.6.0"

}  // namespace pomona
