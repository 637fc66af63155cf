#include "generator/base/beside.h"

#include <system_error>

#include "generator/base/small_ending.h"

namespace pomona {

namespace fs = std::filesystem;

namespace {

/// "photos" of "./photos/".
fs::path plain(const fs::path& path) {
  const fs::path normal = path.lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

}  // namespace

Error told_where_named(const Error& error, const SourcePlace& place) {
  const Diagnostic& what = error.diagnostics().front();
  const std::string file = what.place.file.empty() ? "" : what.place.file + ": ";
  return Error(error.status(), {{place, file + what.message, what.hint}});
}

std::optional<fs::path> found_beside(const fs::path& file, const std::string& path) {
  std::error_code ignored;
  fs::path beside = file.parent_path() / path;
  if (!fs::is_regular_file(beside, ignored)) return {};
  return beside;
}

bool is_style_path(const std::string& name_or_path) {
  return name_or_path.find('/') != std::string::npos || small_ending(name_or_path) == ".toml";
}

std::string style_beside(const fs::path& file, const std::string& style) {
  return is_style_path(style) ? (file.parent_path() / style).string() : style;
}

std::string word_from(const fs::path& folder, const std::string& path) {
  const fs::path typed = plain(path);
  if (typed.is_absolute()) return typed.filename().string();
  if (folder.empty()) return typed.string();
  // What leads to it may be a link, where ".." leads elsewhere than in the words; the last name stays.
  std::error_code wrong;
  const fs::path start = fs::weakly_canonical(fs::absolute(folder, wrong), wrong);
  const fs::path whole = plain(fs::absolute(typed, wrong));
  const fs::path step = (fs::weakly_canonical(whole.parent_path(), wrong) / whole.filename()).lexically_relative(start);
  return wrong || step.empty() ? typed.string() : step.string();
}

}  // namespace pomona
