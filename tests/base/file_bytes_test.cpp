#include "generator/base/file_bytes.h"

#include <sys/stat.h>

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/base/error.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

using testing::HasSubstr;

std::string told(const std::filesystem::path& file, std::size_t max, ExitStatus status) {
  try {
    file_bytes(file, max, "make it smaller");
    ADD_FAILURE() << "was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), status);
    return error.what();
  }
  return {};
}

TEST(FileBytes, AreTheWholeFileUpToTheLimit) {
  const TemporaryFolder folder;
  std::ofstream(folder / "x") << std::string(4096, 'x');
  EXPECT_EQ(file_bytes(folder / "x", 4096), std::string(4096, 'x'));
  EXPECT_EQ(readable_bytes(folder / "x", 10), "xxxxxxxxxx");
  EXPECT_THAT(told(folder / "x", 4095, ExitStatus::bad_data),
              HasSubstr("is larger than 3 KiB\n  hint: make it smaller"));
}

TEST(FileBytes, SayWhyThereAreNone) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_symlink("loop", folder / "loop");
  EXPECT_THAT(told(folder / "none", 10, ExitStatus::input_missing), HasSubstr("there is no such file"));
  EXPECT_THAT(told(folder.path(), 10, ExitStatus::input_missing), HasSubstr("is a folder, not a file"));
  EXPECT_THAT(told(folder / "pipe", 10, ExitStatus::input_missing), HasSubstr("is a device or a pipe, not a file"));
  EXPECT_THAT(told("/dev/zero", 10, ExitStatus::input_missing), HasSubstr("is a device or a pipe, not a file"));
  EXPECT_THAT(told(folder / "loop", 10, ExitStatus::input_missing), HasSubstr("symbolic links"));
  EXPECT_EQ(readable_bytes(folder / "pipe", 10), "");
}

}  // namespace
}  // namespace pomona
