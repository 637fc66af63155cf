// The hash of a template, in 64 digits: for manifests, and to see whether it has changed.
#pragma once

#include <filesystem>
#include <string>

namespace pomona {

/// SHA-256 of the template's file and of all files that it names (sketches, meshes), each with its name and length.
/// \throws Error (input_missing) if it cannot be read, (bad_data) if it is no TOML.
std::string template_hash(const std::filesystem::path& file);

}  // namespace pomona
