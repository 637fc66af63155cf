#include "generator/base/path_within.h"

#include <system_error>

namespace pomona {

std::optional<std::filesystem::path> path_within(const std::filesystem::path& folder,
                                                 const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code wrong;
  const fs::path real_folder = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, wrong);
  if (wrong) return {};
  // Absolute first: what does not exist would stay relative otherwise.
  const fs::path absolute = fs::absolute(file, wrong);
  if (wrong) return {};
  const fs::path real_file = fs::weakly_canonical(absolute, wrong);
  if (wrong) return {};
  const fs::path step = real_file.lexically_relative(real_folder);
  if (step.empty() || *step.begin() == "..") return {};
  return step;
}

}  // namespace pomona
