// Starts the real program, as a user would, and says how it ended.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pomona::testing {

struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs pomona with these words in `folder`; standard output and error are caught.
Outcome run_pomona(const std::vector<std::string>& words, const std::filesystem::path& folder = ".");

/// A new empty folder, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::string bytes_of(const std::filesystem::path& file);

}  // namespace pomona::testing
