// Where the module lies, and with it the templates: in place of cli/options/program_place.cpp.
#include <dlfcn.h>

#include "cli/options/program_place.h"

namespace fs = std::filesystem;

namespace pomona {

namespace {

/// The folder of the package: that of the shared library which holds this function.
fs::path package_folder() {
  Dl_info library{};
  if (dladdr(reinterpret_cast<const void*>(&package_folder), &library) == 0) return {};
  std::error_code ignored;
  return fs::weakly_canonical(library.dli_fname, ignored).parent_path();
}

}  // namespace

/// A wheel brings them in the package; an installed tree has them in share/pomona, some folders up.
std::vector<fs::path> program_folders(const std::string& kind) {
  const fs::path package = package_folder();
  std::vector<fs::path> folders = {package / kind};
  for (fs::path above = package; above != above.parent_path(); above = above.parent_path())
    folders.push_back(above.parent_path() / "share" / "pomona" / kind);
  return folders;
}

}  // namespace pomona
