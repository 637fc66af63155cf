// Finds the place in a template's file of a mistake that only growing has found.
#pragma once

#include <string>

#include "generator/base/error.h"

namespace pomona {

/// The place in a template's file of the entry with this name in a list ("surface", "mesh", "grains"), or the file as a
/// whole if there is none. It reads the file again, so that sketches need not carry places; only mistakes need it.
SourcePlace entry_place(const std::string& file, const std::string& list, const std::string& name);

}  // namespace pomona
