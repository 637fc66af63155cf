// A folder for files that are about to be written.
#pragma once

#include <filesystem>

namespace pomona {

/// Makes the folder if it is not there; takes it away again, as long as it is empty, unless it is told to keep it.
class MadeFolder {
 public:
  /// \param folder none: nothing is made. \throws Error (cannot_create)
  explicit MadeFolder(const std::filesystem::path& folder);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

  void keep() { made_.clear(); }

 private:
  std::filesystem::path made_;
};

}  // namespace pomona
