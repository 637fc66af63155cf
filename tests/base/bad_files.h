// Folders of files that must be refused; the first line of each says where and why.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>

#include "generator/base/error.h"

namespace pomona {

/// Each file's first line says what is expected of read(file): "# expects LINE:COLUMN: part of the message". Returns
/// how many files there are.
template <typename Read>
int expect_told_where_and_why(const std::filesystem::path& folder, const Read& read) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename().string());
    std::string expected;
    std::getline(std::ifstream(entry.path()) >> std::ws, expected);
    const std::string place = expected.substr(10, expected.find(": ") - 10);
    const std::string message = expected.substr(expected.find(": ") + 2);
    ++files;
    try {
      read(entry.path());
      ADD_FAILURE() << "was read";
    } catch (const Error& error) {
      EXPECT_EQ(error.status(), ExitStatus::bad_data);
      const std::string text = to_string(error.diagnostics().front());
      EXPECT_THAT(text, testing::StartsWith(entry.path().string() + ":" + place + ":"));
      EXPECT_THAT(text, testing::HasSubstr(message));
    }
  }
  return files;
}

}  // namespace pomona
