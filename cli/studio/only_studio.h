// One studio for each fruit: a second one on this machine would write over what the first keeps.
#pragma once

#include <filesystem>

#include "render/export/transaction/durable_file.h"

namespace pomona {

/// Held as long as a studio is open. It is a name of the machine's, no file: it goes with the process, however that
/// ends.
class OnlyStudio {
 public:
  /// \param toml the template, which need not be there yet; all paths to one file are the same.
  /// \throws Error (locked) if this user's other studio has it open
  explicit OnlyStudio(const std::filesystem::path& toml);

 private:
  Descriptor socket_;
};

}  // namespace pomona
