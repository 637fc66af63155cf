#include "render/export/output.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <csignal>
#include <fstream>
#include <sstream>

#include "generator/base/error.h"
#include "tests/base/temporary_folder.h"

namespace pomona {
namespace {

namespace fs = std::filesystem;

using testing::HasSubstr;
using testing::UnorderedElementsAre;

class Output : public testing::Test {
 protected:
  std::string content(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name, std::ios::binary).rdbuf();
    return text.str();
  }

  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder_)) result.push_back(entry.path().filename().string());
    return result;
  }

  ExitStatus status_of(const std::vector<OutputFile>& files) const {
    try {
      write_whole(files);
    } catch (const Error& error) {
      EXPECT_FALSE(error.diagnostics().front().place.file.empty());
      return error.status();
    }
    return ExitStatus::done;
  }

  const TemporaryFolder made_;
  const fs::path folder_ = made_.path();
};

TEST_F(Output, ReplacesAFileWhole) {
  write_whole(folder_ / "a", "long old content");
  write_whole(folder_ / "a", "new");
  EXPECT_EQ(content("a"), "new");
  EXPECT_THAT(names(), UnorderedElementsAre("a"));
}

TEST_F(Output, ChangesNothingWhenOneOfSeveralCannotBeMade) {
  write_whole(folder_ / "a", "old");
  EXPECT_EQ(status_of({{folder_ / "a", "new"}, {folder_ / "missing" / "b", "new"}}), ExitStatus::cannot_create);
  EXPECT_EQ(content("a"), "old");
  EXPECT_THAT(names(), UnorderedElementsAre("a"));
}

TEST_F(Output, AFolderIsNoFile) {
  fs::create_directory(folder_ / "b");
  EXPECT_EQ(status_of({{folder_ / "a", "new"}, {folder_ / "b", "new"}}), ExitStatus::cannot_create);
  EXPECT_EQ(status_of({{folder_ / "b" / "", "new"}}), ExitStatus::cannot_create);
  EXPECT_THAT(names(), UnorderedElementsAre("b"));
}

TEST_F(Output, AFullDiskLeavesTheOldFileAndNoRemains) {
  write_whole(folder_ / "a", "old");
  // A limit on the size of files stands in for a full disk: write() fails half-way.
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 4096;
  auto* handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const ExitStatus status = status_of({{folder_ / "a", std::string(100000, 'x')}});
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  EXPECT_EQ(status, ExitStatus::io_error);
  EXPECT_EQ(content("a"), "old");
  EXPECT_THAT(names(), UnorderedElementsAre("a"));
}

TEST_F(Output, KeepsALinkAndReplacesWhatItNames) {
  write_whole(folder_ / "a", "old");
  fs::create_symlink("a", folder_ / "link");
  write_whole(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content("a"), "new");
}

TEST_F(Output, WritesToDevices) {
  EXPECT_EQ(status_of({{"/dev/null", "anything"}}), ExitStatus::done);
  EXPECT_EQ(status_of({{"/dev/full", "anything"}}), ExitStatus::io_error);
}

}  // namespace
}  // namespace pomona
