#include "render/export/transaction/transaction.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "render/export/transaction/recovery.h"

namespace pomona {

namespace {

namespace fs = std::filesystem;

void write_journal(const Participant& participant) {
  write_all(participant.journal_file, journal_bytes(participant.journal), participant.journal_path);
  if (::fsync(participant.journal_file.number()) != 0)
    fail_at(ExitStatus::io_error, participant.journal_path, "cannot be written", errno);
  sync_folder(participant.folder());
}

/// Keeps a file under a second name. Not every file system has second names, and not every file may be given one: there
/// it is copied.
void keep_backup(const fs::path& file, const fs::path& backup) {
  if (::link(file.c_str(), backup.c_str()) == 0) return;
  std::error_code failed;
  fs::copy_file(file, backup, failed);
  if (failed) fail_at(ExitStatus::cannot_create, file, "cannot be kept aside", failed.value());
}

}  // namespace

Transaction::~Transaction() {
  for (const Participant& each : participants_) remove_hidden_files(each);
}

Participant& Transaction::participant_for(const fs::path& folder, const fs::path& meant) {
  for (Participant& known : participants_) {
    std::error_code failed;
    if (fs::equivalent(known.folder(), folder, failed)) return known;
  }
  recover_folder(folder);
  return participants_.emplace_back(new_participant(folder, meant));
}

void Transaction::add(const fs::path& destination, const fs::path& meant, std::string_view bytes,
                      const SpooledBytes* rest) {
  const fs::path folder = destination.has_parent_path() ? destination.parent_path() : fs::path(".");
  Participant& own = participant_for(folder, meant);
  std::vector<JournalEntry>& entries = own.journal.entries;
  const std::string name = destination.filename().native();
  if (std::any_of(entries.begin(), entries.end(), [&](const JournalEntry& entry) { return entry.name == name; })) {
    throw Error(ExitStatus::usage, {{{meant.string(), 0, 0, {}},
                                     "two files of this run would be this one",
                                     "give one of them a name or a folder of its own"}});
  }

  struct stat before {
  }, made{};
  const fs::path path = folder / name;
  const bool replaces = ::lstat(path.c_str(), &before) == 0;
  entries.push_back({name, 0, replaces});
  Descriptor file = create_file(own.pending(entries.size() - 1), path, replaces ? 0600 : 0666);
  if (!file.is_open()) fail_at(ExitStatus::cannot_create, path, "cannot be created", EEXIST);
  if (replaces && ::fchmod(file.number(), before.st_mode & 07777) != 0)
    fail_at(ExitStatus::cannot_create, path, "cannot keep its permissions", errno);
  ::fstat(file.number(), &made);
  entries.back().inode = made.st_ino;
  write_all(file, bytes, path);
  if (rest != nullptr) rest->copy_to(file);
  bring_to_disk(file, path);
}

std::size_t Transaction::file_count() const {
  std::size_t count = 0;
  for (const Participant& each : participants_) count += each.journal.entries.size();
  return count;
}

void Transaction::keep_backups() const {
  for (const Participant& each : participants_)
    for (std::size_t n = 0; n < each.journal.entries.size(); ++n)
      if (each.journal.entries[n].replaces) keep_backup(each.destination(n), each.backup(n));
}

/// The leader's journal comes last: with it the transaction is committed.
void Transaction::write_journals() {
  Participant& leader = participants_.front();
  for (std::size_t i = 1; i < participants_.size(); ++i) {
    participants_[i].journal.leader = fs::absolute(leader.journal_path);
    leader.journal.followers.push_back(fs::absolute(participants_[i].journal_path));
    write_journal(participants_[i]);
  }
  write_journal(leader);
}

void Transaction::roll_back_all(bool has_journals) {
  const int leader = participants_.front().journal_file.number();
  if (has_journals && ::write(leader, rollback_mark.data(), rollback_mark.size()) > 0) ::fsync(leader);
  bool is_rolled_back = true;
  for (const Participant& each : participants_) is_rolled_back = roll_back(each) && is_rolled_back;
  if (!is_rolled_back) participants_.clear();  // nothing is removed: a later run tries again
}

void Transaction::commit() {
  // One renaming is atomic by itself. Several need journals: with these a later run finishes what a kill interrupts.
  const bool has_journals = file_count() > 1;
  if (has_journals) {
    keep_backups();
    write_journals();
  }
  for (const Participant& each : participants_) {
    const std::optional<fs::path> failed = roll_forward(each);
    if (!failed) continue;
    const int why = errno;
    roll_back_all(has_journals);
    fail_at(ExitStatus::cannot_create, *failed, "cannot be put into place", why);
  }
  // The leader goes last, as its journal is needed for the others.
  while (!participants_.empty()) {
    sync_folder(participants_.back().folder());
    remove_hidden_files(participants_.back());
    participants_.pop_back();
  }
}

}  // namespace pomona
