// Starts the real program and returns its result.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/base/temporary_folder.h"

namespace pomona::testing {

struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// Runs pomona with these arguments in `folder`; captures standard output and error.
Outcome run_pomona(const std::vector<std::string>& words, const std::filesystem::path& folder = ".");

std::string bytes_of(const std::filesystem::path& file);

}  // namespace pomona::testing
