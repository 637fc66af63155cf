#include "render/export/output.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <csignal>
#include <fstream>
#include <sstream>

#include "generator/base/error.h"
#include "render/export/transaction/journal.h"
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

TEST_F(Output, RefusesToWriteOneFileTwice) {
  write_whole(folder_ / "a", "old");
  fs::create_directory_symlink(folder_, folder_ / "here");
  fs::create_symlink("a", folder_ / "link");
  for (const fs::path& again : {folder_ / "a", folder_ / "." / "a", folder_ / "here" / "a", folder_ / "link"}) {
    EXPECT_EQ(status_of({{folder_ / "a", "new"}, {again, "other"}}), ExitStatus::usage) << again;
  }
  EXPECT_EQ(content("a"), "old");
  EXPECT_THAT(names(), UnorderedElementsAre("a", "here", "link"));
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
  // A limit of file sizes replaces a full disk: write() fails half-way.
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

TEST_F(Output, MakesWhatALinkNamesThatNamesNothingYet) {
  fs::create_symlink("later", folder_ / "link");
  write_whole(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(content("later"), "new");
}

TEST_F(Output, RefusesLinksThatLeadInACircle) {
  fs::create_symlink("b", folder_ / "a");
  fs::create_symlink("a", folder_ / "b");
  EXPECT_EQ(status_of({{folder_ / "a", "new"}}), ExitStatus::cannot_create);
}

TEST_F(Output, KeepsWhatIsPrivatePrivate) {
  write_whole(folder_ / "a", "old");
  fs::permissions(folder_ / "a", fs::perms::owner_read | fs::perms::owner_write);
  write_whole(std::vector<OutputFile>{{folder_ / "a", "new"}, {folder_ / "b", "new"}});
  EXPECT_EQ(content("a"), "new");
  EXPECT_EQ(fs::status(folder_ / "a").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

/// A later run must not use journals that other users may have written.
TEST_F(Output, LeavesJournalsAloneThatOthersCanWrite) {
  Journal journal;
  journal.entries.push_back({"victim", 0, true});
  write_whole(folder_ / "victim", "mine");
  std::ofstream(folder_ / ".pomona-1-0.journal", std::ios::binary) << journal_bytes(journal);
  std::ofstream(folder_ / ".pomona-1-0-0.part") << "theirs";
  fs::permissions(folder_ / ".pomona-1-0.journal", fs::perms::all);
  write_whole(folder_ / "a", "new");
  EXPECT_EQ(content("victim"), "mine");
  EXPECT_EQ(content(".pomona-1-0-0.part"), "theirs");
}

TEST_F(Output, FinishesWhatADeadRunHadDecided) {
  Journal journal;
  journal.entries = {{"a", 0, true}, {"b", 0, false}};
  write_whole(folder_ / "a", "old");
  std::ofstream(folder_ / ".pomona-1-0.journal", std::ios::binary) << journal_bytes(journal);
  fs::permissions(folder_ / ".pomona-1-0.journal", fs::perms::owner_read | fs::perms::owner_write);
  std::ofstream(folder_ / ".pomona-1-0-0.part") << "new a";
  std::ofstream(folder_ / ".pomona-1-0-1.part") << "new b";
  write_whole(folder_ / "c", "new c");
  EXPECT_EQ(content("a"), "new a");
  EXPECT_EQ(content("b"), "new b");
  EXPECT_THAT(names(), UnorderedElementsAre("a", "b", "c"));
}

TEST_F(Output, ClearsAwayWhatADeadRunHadNotDecided) {
  write_whole(folder_ / "a", "old");
  Journal journal;
  journal.entries = {{"a", 0, true}};
  const std::string whole = journal_bytes(journal);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    std::ofstream(folder_ / ".pomona-1-0.journal", std::ios::binary) << whole.substr(0, size);
    fs::permissions(folder_ / ".pomona-1-0.journal", fs::perms::owner_read | fs::perms::owner_write);
    std::ofstream(folder_ / ".pomona-1-0-0.part") << "new";
    write_whole(folder_ / "c", "new c");
    ASSERT_EQ(content("a"), "old") << "cut off after " << size << " bytes";
    ASSERT_THAT(names(), UnorderedElementsAre("a", "c"));
  }
}

TEST(Journal, ReadsBackWhateverItsNames) {
  Journal journal;
  journal.leader = "/tmp/with a\nline/x.journal";
  journal.followers = {"/tmp/b.journal", "/c"};
  journal.entries = {{"a\xff.glb", 17, true}, {"b", 18446744073709551615u, false}};
  const auto read = parse_journal(journal_bytes(journal) + std::string(rollback_mark));
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(journal_bytes(*read), journal_bytes(journal));
  EXPECT_TRUE(read->is_rolled_back);
  EXPECT_FALSE(parse_journal(journal_bytes(journal))->is_rolled_back);
}

TEST(Journal, LeadsToNoOtherFolder) {
  for (const char* name : {"../a", "a/b", "..", ".", ""}) {
    Journal journal;
    journal.entries = {{name, 1, true}};
    EXPECT_FALSE(parse_journal(journal_bytes(journal)).has_value()) << name;
  }
}

TEST_F(Output, WritesToDevices) {
  EXPECT_EQ(status_of({{"/dev/null", "anything"}}), ExitStatus::done);
  EXPECT_EQ(status_of({{"/dev/full", "anything"}}), ExitStatus::io_error);
}

}  // namespace
}  // namespace pomona
