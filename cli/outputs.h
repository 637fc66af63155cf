// What the user wants written: formats by file name, checked before the work begins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/shared_options.h"

namespace pomona {

enum class Format { ply, glb, usda, obj, stl, pov, png, svg, json, html, pomona };

struct Output {
  std::filesystem::path file;
  Format format = Format::glb;
};

/// One output per name; `allowed` are the formats this command writes. The name "-" is standard output.
/// \param format what goes to standard output, as an ending without its dot; empty: not said.
/// \throws Error (usage) for another ending or the same file twice, Error (cannot_create) where the folder does
/// not exist or cannot be written to.
std::vector<Output> parse_outputs(const std::vector<std::string>& names, const std::vector<Format>& allowed,
                                  const std::string& format = {});

/// Options that none of the outputs can heed, such as a texture where no output has one: a warning for each.
std::vector<std::string> idle_options(const SharedOptions& options, const std::vector<Output>& outputs);

/// Likewise of how variants are drawn, where one fruit is grown as it is drawn. \param seeds of --seeds
std::vector<std::string> idle_variant_options(const SharedOptions& options, const std::string& seeds);

/// \param option "--lod": what was asked for. \param holding the formats that heed it.
/// \throws Error (usage) if no output is one of them.
void check_heeded(const std::string& option, const std::vector<Format>& holding, const std::vector<Output>& outputs);

/// What a command writes beside its outputs: the file of --stats, the answer to --json on standard output, and, where
/// it is not empty, the list of pieces. \throws Error (usage) where two of all these are one file, or both standard
/// output; (cannot_create) for a folder that cannot be written to.
void check_other_files(const SharedOptions& options, const std::vector<Output>& outputs,
                       const std::string& pieces = {});

/// A picture's ground truth goes with one picture, into a folder that is there or can be made.
/// \throws Error (usage) if `outputs` hold no .png or two, (cannot_create) for a folder that cannot be.
void check_aov(const std::filesystem::path& folder, const std::vector<Output>& outputs);

/// The maps of one .glb's textures, likewise into a folder. \throws Error (usage) where there are none to be had, or
/// those of several; (cannot_create)
void check_maps_dir(const SharedOptions& options, const std::vector<Output>& outputs);

/// An absent or read-only folder is told now, not after minutes of work. \throws Error (cannot_create)
void check_folder(const std::filesystem::path& file);

}  // namespace pomona
