// What the user wants written: formats by file name, checked before the work begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/options/telling.h"
#include "generator/order/order.h"

namespace pomona {

/// One output per name; `allowed` are the formats this command writes. The name "-" is standard output.
/// \param format what goes to standard output, as an ending without its dot; empty: not said.
/// \throws Error (usage) for another ending or the same file twice, Error (cannot_create) where the folder does
/// not exist or cannot be written to.
std::vector<Output> parse_outputs(const std::vector<std::string>& names, const std::vector<Format>& allowed,
                                  const std::string& format = {});

/// What a command writes beside its outputs: the file of --stats, the answer to --json on standard output, and the list
/// of pieces. \throws Error (usage) where two of all these are one file, or both standard output; (cannot_create) for a
/// folder that cannot be written to.
void check_other_files(const Order& order, const Telling& telling);

/// A picture's ground truth goes with one picture, into a folder that is there or can be made.
/// \throws Error (usage) if the outputs hold no .png or two, (cannot_create) for a folder that cannot be.
void check_aov(const Order& order);

/// The maps of one .glb's textures, likewise into a folder. \throws Error (usage) where there are none to be had, or
/// those of several; (cannot_create)
void check_maps_dir(const Order& order);

/// An absent or read-only folder is told now, not after minutes of work. \throws Error (cannot_create)
void check_folder(const std::filesystem::path& file);

}  // namespace pomona
