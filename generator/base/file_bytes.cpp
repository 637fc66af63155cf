#include "generator/base/file_bytes.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include "generator/base/error.h"
#include "generator/base/first_bytes.h"
#include "generator/base/nearest_name.h"
#include "generator/base/shell_words.h"

namespace pomona {

namespace {

std::string in_units(std::size_t bytes) {
  const std::size_t mib = std::size_t{1} << 20;
  return bytes >= mib ? std::to_string(bytes / mib) + " MiB" : std::to_string(bytes >> 10) + " KiB";
}

/// The names, without this ending, of the files that have it; of a crowded folder only the first.
std::vector<std::string> stems_in(const std::filesystem::path& folder, const std::filesystem::path& ending) {
  constexpr std::size_t most = 2000;
  std::vector<std::string> names;
  std::error_code failed;
  for (std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, failed), end;
       !failed && entry != end && names.size() < most; entry.increment(failed))
    if (entry->path().extension() == ending) names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

std::string near_file_hint(const std::filesystem::path& missing) {
  constexpr std::size_t shortest = 3;  // a shorter name is near every other
  const std::string name = missing.stem().string();
  std::error_code ignored;
  if (name.size() < shortest || std::filesystem::exists(missing, ignored)) return {};
  const auto near = nearest_name(name, stems_in(missing.parent_path(), missing.extension()));
  if (!near || *near == name) return {};
  return "did you mean " + *near + missing.extension().string() + "?";
}

std::string why_no_file(const std::filesystem::path& file) {
  std::error_code wrong;
  const std::filesystem::file_status found = std::filesystem::status(file, wrong);
  if (std::filesystem::is_regular_file(found)) return {};
  if (std::filesystem::is_directory(found)) return "is a folder, not a file";
  if (std::filesystem::exists(found)) return "is a device or a pipe, not a file";
  const bool is_absent = !wrong || wrong == std::errc::no_such_file_or_directory;
  return is_absent ? "there is no such file" : "cannot be read: " + wrong.message();
}

std::string file_bytes(const std::filesystem::path& file, std::size_t max, const std::string& hint) {
  const auto fail = [&](ExitStatus status, const std::string& why, const std::string& remedy = {}) {
    throw Error(status, {{{file.string(), 0, 0, {}}, why, remedy}});
  };
  const std::string why = why_no_file(file);
  if (!why.empty())
    fail(ExitStatus::input_missing, why, unread_home_hint(file.string()).value_or(near_file_hint(file)));
  const auto too_large = [&] { fail(ExitStatus::bad_data, "is larger than " + in_units(max), hint); };
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (!unknown && size > max) too_large();

  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    fail(ExitStatus::input_missing,
         "cannot be read" + (errno != 0 ? ": " + std::error_code(errno, std::generic_category()).message() : ""));

  // All at once, and what it may have grown by since.
  std::string bytes(unknown ? 0 : static_cast<std::size_t>(size), '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (stream) bytes += first_bytes(stream, max + 1 - bytes.size());
  if (stream.bad()) fail(ExitStatus::io_error, "cannot be read to its end");
  if (bytes.size() > max) too_large();
  return bytes;
}

std::string readable_bytes(const std::filesystem::path& file, std::size_t max) {
  if (!why_no_file(file).empty()) return {};
  std::ifstream stream(file, std::ios::binary);
  return first_bytes(stream, max);
}

}  // namespace pomona
