// Finds the place in a template's file of a mistake that only growing has found, and reports it there.
#pragma once

#include <string>

#include "generator/base/error.h"

namespace pomona {

struct Template;

/// The place in a template's file of the entry with this name in a list ("surface", "mesh", "grains"), or the file as a
/// whole if there is none. It reads the file again, so that sketches need not carry places; only mistakes need it.
SourcePlace entry_place(const std::string& file, const std::string& list, const std::string& name);

/// Throws the Error (bad_data) for an entry of a list that cannot be grown: at its place in the template's file, with
/// list and name before the message.
[[noreturn]] void refuse_entry(const Template& fruit, const std::string& list, const std::string& name,
                               const std::string& message, const std::string& hint);

}  // namespace pomona
