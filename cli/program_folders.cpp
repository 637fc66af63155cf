#include "cli/program_folders.h"

namespace fs = std::filesystem;

namespace pomona {

std::vector<fs::path> program_folders(const std::string& kind) {
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  const fs::path root = program.parent_path().parent_path();
  return {root / kind, root / "share" / "pomona" / kind};
}

std::vector<fs::path> searched_folders(const std::string& kind) {
  std::vector<fs::path> candidates = program_folders(kind);
  candidates.insert(candidates.end(), {kind, "."});
  std::vector<fs::path> folders;
  for (const fs::path& folder : candidates) {
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) folders.push_back(folder);
  }
  return folders;
}

}  // namespace pomona
