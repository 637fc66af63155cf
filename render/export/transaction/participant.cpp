#include "render/export/transaction/participant.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

namespace pomona {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_journal_bytes = std::size_t{1} << 20;
constexpr std::string_view name_beginning = ".pomona-", journal_ending = ".journal";

fs::path hidden_file(const fs::path& journal_path, std::size_t n, const char* ending) {
  return journal_path.parent_path() / (journal_path.stem().native() + "-" + std::to_string(n) + ending);
}

/// The names in a folder for which the condition holds.
template <typename Condition>
std::vector<fs::path> files_in(const fs::path& folder, const Condition& condition) {
  std::vector<fs::path> files;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
    if (condition(entry.path().filename().native())) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// All bytes of a journal, if only we can have written them.
std::optional<std::string> trusted_bytes(const Descriptor& file) {
  struct stat found {};
  if (::fstat(file.number(), &found) != 0 || !S_ISREG(found.st_mode)) return {};
  if (found.st_uid != ::geteuid() || (found.st_mode & (S_IWGRP | S_IWOTH)) != 0) return {};
  if (found.st_size < 0 || static_cast<std::size_t>(found.st_size) > max_journal_bytes) return {};
  std::string bytes(static_cast<std::size_t>(found.st_size), '\0');
  const ssize_t count = ::pread(file.number(), bytes.data(), bytes.size(), 0);
  if (count < 0) return {};
  bytes.resize(static_cast<std::size_t>(count));
  return bytes;
}

bool is_there(const fs::path& path) {
  struct stat found {};
  return ::lstat(path.c_str(), &found) == 0;
}

}  // namespace

fs::path Participant::pending(std::size_t n) const { return hidden_file(journal_path, n, ".part"); }
fs::path Participant::backup(std::size_t n) const { return hidden_file(journal_path, n, ".old"); }

Participant new_participant(const fs::path& folder, const fs::path& meant) {
  for (int n = 0;; ++n) {
    // The process number alone is not unique: another machine may share the folder.
    const std::string stem = std::string(name_beginning) + std::to_string(::getpid()) + "-" + std::to_string(n);
    fs::path path = folder / (stem + std::string(journal_ending));
    Descriptor file = create_file(path, meant, 0600);
    if (!file.is_open()) continue;
    // Before the lock was set, another run may have locked the file, and removed it as that of a dead run.
    const bool is_busy = ::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!is_busy && is_still_there(file, path)) return {std::move(path), std::move(file)};
  }
}

std::optional<Participant> dead_participant(const fs::path& journal_path) {
  Descriptor file(::open(journal_path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
  if (!file.is_open() || ::flock(file.number(), LOCK_EX | LOCK_NB) != 0) return {};
  const std::optional<std::string> bytes = trusted_bytes(file);
  if (!bytes || !is_still_there(file, journal_path)) return {};
  std::optional<Journal> journal = parse_journal(*bytes);
  const bool is_complete = journal.has_value();
  return Participant{journal_path, std::move(file), std::move(journal).value_or(Journal{}), is_complete};
}

std::vector<fs::path> journals_in(const fs::path& folder) {
  return files_in(folder, [](const std::string& name) {
    return name.starts_with(name_beginning) && name.ends_with(journal_ending);
  });
}

std::optional<fs::path> roll_forward(const Participant& participant) {
  for (std::size_t n = 0; n < participant.journal.entries.size(); ++n) {
    const fs::path pending = participant.pending(n), destination = participant.destination(n);
    if (is_there(pending) && ::rename(pending.c_str(), destination.c_str()) != 0) return destination;
  }
  return {};
}

bool roll_back(const Participant& participant) {
  bool is_done = true;
  for (std::size_t n = 0; n < participant.journal.entries.size(); ++n) {
    const JournalEntry& entry = participant.journal.entries[n];
    const fs::path destination = participant.destination(n), backup = participant.backup(n);
    struct stat found {};
    const bool has_file = ::lstat(destination.c_str(), &found) == 0;
    const bool is_new = has_file && found.st_ino == entry.inode && !is_there(participant.pending(n));
    if (is_new && is_there(backup)) {
      is_done = ::rename(backup.c_str(), destination.c_str()) == 0 && is_done;
    } else if (is_new && !entry.replaces) {
      is_done = ::unlink(destination.c_str()) == 0 && is_done;
    }
  }
  return is_done;
}

void remove_hidden_files(const Participant& participant) {
  const std::string beginning = participant.journal_path.stem().native() + "-";
  const auto belongs = [&](const std::string& name) { return name.starts_with(beginning); };
  for (const fs::path& path : files_in(participant.folder(), belongs)) ::unlink(path.c_str());
  ::unlink(participant.journal_path.c_str());
}

}  // namespace pomona
