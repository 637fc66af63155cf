// Copies a file that a new template reads beside the template.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "render/export/output.h"

namespace pomona {

/// Nothing if these bytes lie there already.
/// \param what the file they come from,
/// \param hint what to do otherwise, for messages.
/// \throws Error (cannot_create) if another file has the copy's name.
std::optional<OutputFile> copy_beside(const std::filesystem::path& copy, const std::string& bytes,
                                      const std::string& what, const std::string& hint);

}  // namespace pomona
