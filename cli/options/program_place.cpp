#include "cli/options/program_place.h"

#include <sys/auxv.h>

namespace fs = std::filesystem;

namespace pomona {

fs::path this_program() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  if (!failed) return program;
  const auto* started_as = reinterpret_cast<const char*>(getauxval(AT_EXECFN));
  return started_as != nullptr ? fs::weakly_canonical(started_as, failed) : fs::path();
}

std::vector<fs::path> program_folders(const std::string& kind) {
  const fs::path root = this_program().parent_path().parent_path();
  return {root / kind, root / "share" / "pomona" / kind};
}

}  // namespace pomona
