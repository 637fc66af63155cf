// What is wrong with a drawing, as users are told of it where no template names it.
#pragma once

#include <string>

#include "generator/base/error.h"
#include "generator/text/svg_drawing.h"

namespace pomona {

/// A message of BadSketch that begins with a place in this file, as a diagnostic at that place; any other at its start.
Diagnostic placed_fault(const BadSketch& bad, const std::string& file);

}  // namespace pomona
