#include "cli/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

#include "generator/base/error.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::array<std::pair<const char*, Format>, 8> endings = {{{".ply", Format::ply},
                                                                    {".glb", Format::glb},
                                                                    {".pov", Format::pov},
                                                                    {".png", Format::png},
                                                                    {".svg", Format::svg},
                                                                    {".json", Format::json},
                                                                    {".html", Format::html},
                                                                    {".pomona", Format::pomona}}};

std::string list_of(const std::vector<Format>& allowed) {
  std::string list;
  for (const auto& [ending, format] : endings) {
    if (std::find(allowed.begin(), allowed.end(), format) != allowed.end())
      list += std::string(list.empty() ? "" : " ") + ending;
  }
  return list;
}

}  // namespace

void check_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ExitStatus::cannot_create,
                {{{file.string(), 0, 0, {}}, "its folder does not exist", "mkdir -p " + folder.string()}});
  }
  if (access(folder.c_str(), W_OK) != 0 || fs::is_directory(file, ignored)) {
    throw Error(ExitStatus::cannot_create, {{{file.string(), 0, 0, {}}, "it cannot be created there", {}}});
  }
}

std::vector<Output> parse_outputs(const std::vector<std::string>& names, const std::vector<Format>& allowed) {
  std::vector<Output> outputs;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    const fs::path file = name;
    std::optional<Format> format;
    for (const auto& [ending, candidate] : endings) {
      if (file.extension() == ending) format = candidate;
    }
    if (!format || std::find(allowed.begin(), allowed.end(), *format) == allowed.end()) {
      throw Error(ExitStatus::usage, "-o " + name + ": this command cannot write that",
                  "it writes " + list_of(allowed));
    }
    if (!seen.insert(file.lexically_normal().string()).second) {
      throw Error(ExitStatus::usage, "-o " + name + " is given twice");
    }
    check_folder(file);
    outputs.push_back({file, *format});
  }
  return outputs;
}

void check_levels(int levels, const std::vector<Output>& outputs) {
  const auto is_glb = [](const Output& output) { return output.format == Format::glb; };
  if (levels > 0 && std::none_of(outputs.begin(), outputs.end(), is_glb))
    throw Error(ExitStatus::usage, "--lod is about .glb: no output is one", "add -o FILE.glb");
}

}  // namespace pomona
