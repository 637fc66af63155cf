#include <cstdint>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "generator/base/file_bytes.h"
#include "generator/base/path_within.h"
#include "generator/template/read/sketch.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

constexpr std::uintmax_t max_bytes = std::uintmax_t{64} << 20;

/// Reads the SVG beside a template: no file outside its folder, no device or pipe.
fs::path find_svg(const fs::path& folder, const std::string& name) {
  const std::string quoted = "\"" + name.substr(0, 200) + "\"";
  const fs::path file = folder / name;
  if (fs::path(name).is_absolute() || !path_within(folder, file)) {
    throw BadSketch(quoted + " leads out of the template's folder", "put the SVG beside the template");
  }
  std::error_code wrong;
  if (!fs::is_regular_file(file, wrong)) {
    const std::string near = near_file_hint(file);
    throw BadSketch(quoted + " cannot be read",
                    near.empty() ? "put it beside the template; `pomona sketch` writes one to start from" : near);
  }
  const std::uintmax_t bytes = fs::file_size(file, wrong);
  if (wrong || bytes > max_bytes) {
    throw BadSketch(quoted + " is larger than 64 MiB", "link the picture instead of embedding it");
  }
  return file;
}

}  // namespace

Sketch read_sketch(const fs::path& folder, const std::string& name, std::optional<double> unit) {
  const fs::path file = find_svg(folder, name);
  std::ifstream stream(file, std::ios::binary);
  std::string text(fs::file_size(file), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (static_cast<std::size_t>(stream.gcount()) != text.size())
    throw BadSketch("\"" + name + "\" cannot be read to its end",
                    "see whether it is whole, and whether you may read it");
  return {parse_svg(text, file.string()), unit};
}

Sketch read_sketch(const fs::path& folder, const std::string& name, std::optional<double> unit, std::string_view svg) {
  return {parse_svg(svg, (folder / name).string()), unit};
}

}  // namespace pomona
