// The outputs of a command, checked before the work begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options/telling.h"
#include "generator/order/order.h"

namespace pomona {

/// One output per name; `allowed` are the formats of this command. The name "-" is standard output.
/// \param format of standard output, as an ending without its dot; empty = not given.
/// \throws Error (usage) for another ending or the same file twice, Error (cannot_create) where the folder does
/// not exist or cannot be written to.
std::vector<Output> parse_outputs(const std::vector<std::string>& names, const std::vector<Format>& allowed,
                                  const std::string& format = {});

/// Checks the other files of a command: --stats, the answer to --json on standard output, and the list of pieces.
/// \throws Error (usage) if two of all these are one file, or both are standard output; (cannot_create) if a folder
/// cannot be written to.
void check_other_files(const Order& order, const Telling& telling);

/// Checks --aov: ground truth needs exactly one picture, and a folder that exists or can be made.
/// \throws Error (usage) without a .png or with two, (cannot_create) for a folder that cannot be made.
void check_aov(const Order& order);

/// Checks --maps-dir: maps need the textures of exactly one .glb, and a folder. \throws Error (usage) without textures
/// or with several .glb; (cannot_create)
void check_maps_dir(const Order& order);

/// Refuses a path in a missing folder. \throws Error (cannot_create)
void check_folder_there(const std::filesystem::path& file);

/// Refuses a missing or read-only folder before minutes of work. \throws Error (cannot_create)
void check_folder(const std::filesystem::path& file);

}  // namespace pomona
