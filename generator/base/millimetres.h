// Lengths in messages.
#pragma once

#include <string>

namespace pomona {

/// "1.2 mm": a length in metres to three digits; locale-independent.
std::string in_millimetres(double length);

}  // namespace pomona
