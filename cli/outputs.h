// What the user wants written: formats by file name, checked before the work begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona {

enum class Format { ply, glb, pov, png, svg, json, html, pomona };

struct Output {
  std::filesystem::path file;
  Format format = Format::glb;
};

/// One output per name; `allowed` are the formats this command writes.
/// \throws Error (usage) for another ending or the same file twice, Error (cannot_create) where the folder does
/// not exist or cannot be written to.
std::vector<Output> parse_outputs(const std::vector<std::string>& names, const std::vector<Format>& allowed);

/// \throws Error (usage) if levels of detail are asked for, and no output holds them.
void check_levels(int levels, const std::vector<Output>& outputs);

/// An absent or read-only folder is told now, not after minutes of work. \throws Error (cannot_create)
void check_folder(const std::filesystem::path& file);

}  // namespace pomona
