// One studio for each fruit: a second one on this machine would overwrite the edits of the first.
#pragma once

#include <filesystem>

#include "render/export/transaction/durable_file.h"

namespace pomona {

/// A lock that a studio holds as long as it is open: an abstract socket, not a file, so that it disappears with the
/// process in every case.
class OnlyStudio {
 public:
  /// \param toml the template, which may not exist yet; all paths to a file are the same lock.
  /// \throws Error (locked) if another studio of this user has it open
  explicit OnlyStudio(const std::filesystem::path& toml);

 private:
  Descriptor socket_;
};

}  // namespace pomona
