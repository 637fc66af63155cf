#include "cli/deliver/made_folder.h"

#include <system_error>

#include "generator/base/error.h"

namespace pomona {

MadeFolder::MadeFolder(const std::filesystem::path& folder) {
  if (folder.empty()) return;
  std::error_code failed;
  if (std::filesystem::create_directory(folder, failed)) made_ = folder;
  if (failed)
    throw Error(ExitStatus::cannot_create, {{{folder.string(), 0, 0, {}}, "cannot be made: " + failed.message(), {}}});
}

MadeFolder::~MadeFolder() {
  std::error_code ignored;  // a folder with files stays
  if (!made_.empty()) std::filesystem::remove(made_, ignored);
}

}  // namespace pomona
