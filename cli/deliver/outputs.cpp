#include "cli/deliver/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "generator/base/error.h"
#include "generator/base/shell_words.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

bool has_control_character(const std::string& name) {
  return std::any_of(name.begin(), name.end(), [](unsigned char byte) { return byte < 0x20 || byte == 0x7f; });
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// An ending as formats are called: ".png" is "png".
std::string without_dot(const std::string& ending) { return ending.substr(ending.starts_with('.') ? 1 : 0); }

}  // namespace

void check_folder_there(const fs::path& file) {
  const fs::path folder = folder_of(file);
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ExitStatus::cannot_create,
                {{{file.string(), 0, 0, {}},
                  "its folder does not exist",
                  unread_home_hint(folder.string()).value_or("mkdir -p " + shell_word(folder.string()))}});
  }
}

void check_folder(const fs::path& file) {
  check_folder_there(file);
  const fs::path folder = folder_of(file);
  std::error_code ignored;
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
    const std::optional<Format> wanted =
        format_called(without_dot(to_standard_output ? format : file.extension().string()));
    if (!to_standard_output && file.extension().empty())
      throw Error(ExitStatus::usage, "-o \"" + name + "\": it has no ending, which would say what to write",
                  "this command writes " + endings_of(allowed));
    if (!wanted || std::find(allowed.begin(), allowed.end(), *wanted) == allowed.end()) {
      throw Error(ExitStatus::usage,
                  (to_standard_output ? "--format " + format : "-o " + name) + ": this command cannot write that",
                  "it writes " + endings_of(allowed));
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

void check_other_files(const Order& order, const Telling& telling) {
  std::map<fs::path, std::string> taken;  // by which option
  for (const Output& output : order.outputs) taken[output.file.lexically_normal()] = "-o " + output.file.string();
  const auto take = [&](const std::string& option, const fs::path& file) {
    const auto [known, is_new] = taken.emplace(file.lexically_normal(), option);
    if (is_new) return;
    if (file == "-")
      throw Error(ExitStatus::usage, option + " and " + known->second + " both write to standard output",
                  "leave out one of them, or give it a file");
    throw Error(ExitStatus::usage, option + " is an output already: " + known->second, "give it a name of its own");
  };
  if (telling.json) take("--json", "-");
  for (const auto& [option, file] :
       {std::pair("--pieces ", order.cut.piece_list), std::pair("--stats ", telling.stats)}) {
    if (file.empty()) continue;
    take(option + file, file);
    if (file != "-") check_folder(file);
  }
}

namespace {

std::ptrdiff_t count_of(const std::vector<Output>& outputs, Format format) {
  return std::count_if(outputs.begin(), outputs.end(), [&](const Output& output) { return output.format == format; });
}

/// Checks that an existing folder can take the file `name`; a missing folder is made later.
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

void check_aov(const Order& order) {
  if (order.picture.aov.empty()) return;
  const auto pictures = count_of(order.outputs, Format::png);
  if (pictures != 1)
    throw Error(
        ExitStatus::usage,
        "--aov says what one picture shows, and there " + std::string(pictures == 0 ? "is none" : "are several"),
        "give one -o FILE.png");
  check_files_folder(order.picture.aov, "annotations.json");
}

void check_maps_dir(const Order& order) {
  if (order.mesh.maps_dir.empty()) return;
  if (!wants_textures(order.mesh))
    throw Error(ExitStatus::usage, "--maps-dir: there are no textures", "add --texture 1024");
  if (count_of(order.outputs, Format::glb) != 1)
    throw Error(ExitStatus::usage, "--maps-dir is about one .glb's textures", "give one -o FILE.glb");
  check_files_folder(order.mesh.maps_dir, "parts.json");
}

}  // namespace pomona
