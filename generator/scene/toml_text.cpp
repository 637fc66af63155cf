#include "generator/scene/toml_text.h"

#include <fstream>

#include "generator/base/error.h"
#include "generator/template/read/toml_limits.h"

namespace pomona {

std::string read_toml_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file))
    throw Error(ExitStatus::input_missing, {{{file.string(), 0, 0, {}}, "cannot be read", {}}});
  std::string text(TomlLimits{}.bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace pomona
