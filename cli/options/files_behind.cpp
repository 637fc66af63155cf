#include "cli/options/files_behind.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <system_error>
#include <utility>

#include "cli/options/program_folders.h"
#include "generator/base/error.h"
#include "generator/base/small_ending.h"
#include "generator/text/toml_node.h"
#include "generator/text/toml_text.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::size_t max_files = 10000, longest_word = 255;

class FilesBehind {
 public:
  /// Follows a word of the command line, or a text in a TOML file of `folder`.
  void add_word(const std::string& word, const fs::path& folder) {
    if (word.empty() || word.size() > longest_word || found_.size() > max_files) return;
    if (!followed_.emplace(folder, word).second) return;
    add_file(folder / word);
    for (const char* kind : {"templates", "scenes", "styles"})
      if (const std::optional<fs::path> file = file_of(kind, word)) add_file(*file);
  }
  std::set<fs::path> take() { return std::move(found_); }

 private:
  void add_file(const fs::path& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored) || !found_.insert(file.lexically_normal()).second) return;
    if (small_ending(file) != ".toml") return;
    try {
      add_texts(parse_toml(read_toml_text(file), file.string()), file.parent_path());
    } catch (const Error&) {
      // Its errors are reported when it is read.
    }
  }
  void add_texts(const TomlNode& node, const fs::path& folder) {
    if (node.kind == TomlNode::Kind::string) add_word(node.text, folder);
    for (const TomlNode& item : node.items) add_texts(item, folder);
    for (const TomlEntry& entry : node.entries) add_texts(entry.value, folder);
  }

  std::set<fs::path> found_;
  std::set<std::pair<fs::path, std::string>> followed_;  // folders, and words in their files
};

}  // namespace

std::set<fs::path> files_behind(const std::vector<std::string>& words) {
  FilesBehind files;
  for (const std::string& word : words) {
    files.add_word(word, {});
    // mesh:blade.ply,scale=2
    for (std::size_t at = 0; at < word.size();) {
      const std::size_t end = std::min(word.find_first_of(":,=", at), word.size());
      if (end - at < word.size()) files.add_word(word.substr(at, end - at), {});
      at = end + 1;
    }
  }
  return files.take();
}

void check_not_read(const std::vector<std::string>& written, const std::vector<std::string>& words) {
  std::set<fs::path> files;
  for (const std::string& name : written) {
    std::error_code ignored;
    // A scene's layout may be written to the file it was read from: it is the same.
    if (name.empty() || name.ends_with(".json") || !fs::is_regular_file(name, ignored)) continue;
    if (files.empty()) files = files_behind(words);
    const auto is_it = [&](const fs::path& file) { return fs::equivalent(file, name, ignored); };
    if (std::any_of(files.begin(), files.end(), is_it))
      throw Error(ExitStatus::usage, name + " is read by this command, and would be written over",
                  "give what is written a name of its own");
  }
}

}  // namespace pomona
