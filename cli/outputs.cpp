#include "cli/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "generator/base/error.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::array<std::pair<const char*, Format>, 11> endings = {{{".ply", Format::ply},
                                                                     {".glb", Format::glb},
                                                                     {".usda", Format::usda},
                                                                     {".obj", Format::obj},
                                                                     {".stl", Format::stl},
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

/// Whether any of the outputs is of one of these formats.
bool any_is(const std::vector<Output>& outputs, const std::vector<Format>& formats) {
  return std::any_of(outputs.begin(), outputs.end(), [&](const Output& output) {
    return std::find(formats.begin(), formats.end(), output.format) != formats.end();
  });
}

/// Endings are taken in capitals, too.
std::optional<Format> format_of(std::string ending) {
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  for (const auto& [known, format] : endings)
    if (ending == known) return format;
  return std::nullopt;
}

bool has_control_character(const std::string& name) {
  return std::any_of(name.begin(), name.end(), [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; });
}

}  // namespace

void check_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ExitStatus::cannot_create,
                {{{file.string(), 0, 0, {}}, "its folder does not exist", "mkdir -p " + folder.string()}});
  }
  const int refused = fs::is_directory(file, ignored) ? EISDIR : access(folder.c_str(), W_OK) != 0 ? errno : 0;
  if (refused != 0) {
    const std::string why = std::error_code(refused, std::generic_category()).message();
    throw Error(ExitStatus::cannot_create, {{{file.string(), 0, 0, {}}, "it cannot be created there: " + why, {}}});
  }
}

std::vector<Output> parse_outputs(const std::vector<std::string>& names, const std::vector<Format>& allowed,
                                  const std::string& format) {
  std::vector<Output> outputs;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    const bool to_standard_output = name == "-";
    if (to_standard_output && format.empty())
      throw Error(ExitStatus::usage, "-o - is standard output, which has no ending",
                  "add --format glb, or another one");
    const fs::path file = name;
    const std::optional<Format> wanted = format_of(to_standard_output ? "." + format : file.extension().string());
    if (!to_standard_output && file.extension().empty())
      throw Error(ExitStatus::usage, "-o \"" + name + "\": it has no ending, which would say what to write",
                  "this command writes " + list_of(allowed));
    if (!wanted || std::find(allowed.begin(), allowed.end(), *wanted) == allowed.end()) {
      throw Error(ExitStatus::usage,
                  (to_standard_output ? "--format " + format : "-o " + name) + ": this command cannot write that",
                  "it writes " + list_of(allowed));
    }
    if (!seen.insert(file.lexically_normal().string()).second) {
      throw Error(ExitStatus::usage, "-o " + name + " is given twice");
    }
    if (to_standard_output && *wanted == Format::pov)
      throw Error(ExitStatus::usage, "--format pov makes two files, and standard output is one", "write -o FILE.pov");
    if (*wanted == Format::pov && has_control_character(name))
      throw Error(ExitStatus::usage, "-o " + name + ": its name has a control character",
                  "a .pov includes the file of its meshes by a name like its own: give it one in a line");
    if (!to_standard_output) check_folder(file);
    outputs.push_back({file, *wanted});
  }
  if (!format.empty() && !seen.contains("-"))
    throw Error(ExitStatus::usage, "--format is about standard output, and no output is that", "add -o -");
  return outputs;
}

std::vector<std::string> idle_options(const SharedOptions& options, const std::vector<Output>& outputs) {
  std::vector<std::string> warnings;
  const auto warn_if = [&](bool is_idle, const char* warning) {
    if (is_idle) warnings.emplace_back(warning);
  };
  const SharedOptions usual;
  const bool has_picture = any_is(outputs, {Format::png, Format::svg});
  const bool has_mesh_of_textures = any_is(outputs, {Format::glb, Format::usda});
  warn_if(wants_textures(options) && !has_mesh_of_textures,
          "--texture and --texel are about .glb and .usda: no output is one, and nothing is baked");
  warn_if(options.maps != usual.maps && !wants_textures(options),
          "--maps is about textures: --texture 1024 asks for them");
  warn_if(!options.size.empty() && !has_picture, "--size is about pictures: no output is one");
  warn_if(options.dpi != usual.dpi && !has_picture, "--dpi is about pictures: no output is one");
  warn_if(!options.view.empty() && !has_picture, "--view is about pictures: no output is one");
  warn_if(options.aov_format != usual.aov_format && options.aov.empty(),
          "--aov-format is about --aov, which is not there");
  const auto has_no_look = [](const Output& output) {
    return output.format == Format::stl || output.format == Format::json;
  };
  warn_if(!options.style.empty() && std::all_of(outputs.begin(), outputs.end(), has_no_look),
          "--style is about colours and lines: no output has any");
  return warnings;
}

std::vector<std::string> idle_variant_options(const SharedOptions& options, const std::string& seeds) {
  const bool is_drawn = options.seed == 0 && !options.index && seeds.empty();
  const bool is_asked = options.curves_only || options.as_drawn || options.variation != SharedOptions().variation;
  if (!is_drawn || !is_asked) return {};
  return {"--variation, --curves-only and --as-drawn are about variants, and seed 0 is as drawn: --seed 1 is one"};
}

void check_other_files(const SharedOptions& options, const std::vector<Output>& outputs, const std::string& pieces) {
  std::map<fs::path, std::string> taken;  // by what option
  for (const Output& output : outputs) taken[output.file.lexically_normal()] = "-o " + output.file.string();
  const auto take = [&](const std::string& option, const fs::path& file) {
    const auto [known, is_new] = taken.emplace(file.lexically_normal(), option);
    if (is_new) return;
    if (file == "-")
      throw Error(ExitStatus::usage, option + " and " + known->second + " both write to standard output",
                  "leave out one of them, or give it a file");
    throw Error(ExitStatus::usage, option + " is an output already: " + known->second, "give it a name of its own");
  };
  if (options.json) take("--json", "-");
  for (const auto& [option, file] : {std::pair("--pieces ", pieces), std::pair("--stats ", options.stats)}) {
    if (file.empty()) continue;
    take(option + file, file);
    if (file != "-") check_folder(file);
  }
}

void check_heeded(const std::string& option, const std::vector<Format>& holding, const std::vector<Output>& outputs) {
  if (any_is(outputs, holding)) return;
  const std::string list = list_of(holding);
  throw Error(ExitStatus::usage, option + " is about " + list + ": no output is one",
              "add -o FILE" + list.substr(0, list.find(' ')));
}

namespace {

/// A folder that is there takes files, one of them being `name`; one that is not is made when they are.
void check_files_folder(const fs::path& folder, const char* name) {
  const fs::path place = folder.has_filename() ? folder : folder.parent_path();
  std::error_code ignored;
  if (fs::is_directory(place, ignored)) return check_folder(place / name);
  if (fs::exists(fs::symlink_status(place, ignored))) {
    throw Error(ExitStatus::cannot_create, {{{place.string(), 0, 0, {}}, "is a file, not a folder", {}}});
  }
  check_folder(place);
}

}  // namespace

void check_aov(const fs::path& folder, const std::vector<Output>& outputs) {
  if (folder.empty()) return;
  const auto pictures =
      std::count_if(outputs.begin(), outputs.end(), [](const Output& output) { return output.format == Format::png; });
  if (pictures != 1) {
    throw Error(
        ExitStatus::usage,
        "--aov says what one picture shows, and there " + std::string(pictures == 0 ? "is none" : "are several"),
        "give one -o FILE.png");
  }

  check_files_folder(folder, "annotations.json");
}

void check_maps_dir(const SharedOptions& options, const std::vector<Output>& outputs) {
  if (options.maps_dir.empty()) return;
  if (!wants_textures(options))
    throw Error(ExitStatus::usage, "--maps-dir: there are no textures", "add --texture 1024");
  const auto files =
      std::count_if(outputs.begin(), outputs.end(), [](const Output& output) { return output.format == Format::glb; });
  if (files != 1) throw Error(ExitStatus::usage, "--maps-dir is about one .glb's textures", "give one -o FILE.glb");
  check_files_folder(options.maps_dir, "parts.json");
}

}  // namespace pomona
