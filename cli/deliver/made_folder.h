// A folder for files that will be written.
#pragma once

#include <filesystem>

namespace pomona {

/// Makes the folder if it is missing; removes it again if it is empty, unless keep() was called.
class MadeFolder {
 public:
  /// \param folder empty = none. \throws Error (cannot_create)
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

  void keep() { made_.clear(); }

 private:
  std::filesystem::path made_;
};

}  // namespace pomona
