// Where a template says what was found wrong with it only when it was grown.
#pragma once

#include <string>

#include "generator/base/error.h"

namespace pomona {

/// The place of the entry of a list ("surface", "mesh", "grains") with this name in a template's file; the file as a
/// whole where it cannot be told. The file is read again: it is asked for when there is something to complain of, and
/// sketches need not carry places around.
SourcePlace entry_place(const std::string& file, const std::string& list, const std::string& name);

}  // namespace pomona
