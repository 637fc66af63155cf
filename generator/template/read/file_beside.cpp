#include "generator/template/read/file_beside.h"

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"
#include "generator/base/path_within.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr const char* beside = "put the file beside the template";

}  // namespace

std::string hint_for_missing(const fs::path& file) {
  const std::string near = near_file_hint(file);
  return near.empty() ? beside : near;
}

std::optional<fs::path> file_beside(const TomlValue& value, const fs::path& folder) {
  const fs::path file = folder / value.text();
  if (!fs::path(value.text()).is_absolute() && path_within(folder, file)) return file;
  value.error("leads out of the template's folder", beside);
  return {};
}

std::optional<std::string> bytes_beside(const TomlValue& value, const fs::path& file, std::size_t max,
                                        const std::string& smaller) {
  try {
    return file_bytes(file, max);
  } catch (const Error& error) {
    const bool is_long = error.status() == ExitStatus::bad_data;
    const std::string& why = error.diagnostics().front().message;
    value.error(is_long ? why : "cannot be read: " + why, is_long ? smaller : hint_for_missing(file));
    return {};
  }
}

}  // namespace pomona
