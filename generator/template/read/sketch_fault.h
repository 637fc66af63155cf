// Reports faults of a drawing that no template names.
#pragma once

#include <string>

#include "generator/base/error.h"
#include "generator/text/svg_drawing.h"

namespace pomona {

/// Makes a diagnostic of a message of BadSketch, at the place in this file with which it begins, else at the file's
/// start.
Diagnostic placed_fault(const BadSketch& bad, const std::string& file);

}  // namespace pomona
