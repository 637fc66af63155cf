#include "cli/sketch/copy_beside.h"

#include "generator/base/error.h"
#include "generator/base/file_bytes.h"

namespace fs = std::filesystem;

namespace pomona {

std::optional<OutputFile> copy_beside(const fs::path& copy, const std::string& bytes, const std::string& what,
                                      const std::string& hint) {
  if (!fs::exists(copy)) return OutputFile{copy, bytes};
  if (readable_bytes(copy, bytes.size() + 1) == bytes) return std::nullopt;
  throw Error(ExitStatus::cannot_create,
              {{{copy.string(), 0, 0, {}}, "another file than " + what + " has its name here", hint}});
}

}  // namespace pomona
