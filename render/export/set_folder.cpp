#include "render/export/set_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

namespace pomona {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_record_bytes = std::size_t{1} << 20;
constexpr std::string_view record_ending = ".set";

fs::path part_of(const fs::path& folder, const std::string& stem, std::size_t n) {
  return folder / (stem + "-" + std::to_string(n) + ".part");
}

fs::path old_of(const fs::path& folder, const std::string& stem, std::size_t n) {
  return folder / (stem + "-" + std::to_string(n) + ".old");
}

std::optional<struct stat> about(const fs::path& path) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0) return {};
  return found;
}

/// \returns whether all of it is in place.
bool finish(const fs::path& folder, const std::string& stem, const SetRecord& record) {
  for (std::size_t n = 0; n < record.members.size(); ++n) {
    const fs::path part = part_of(folder, stem, n);
    if (about(part) && ::rename(part.c_str(), (folder / record.members[n].name).c_str()) != 0) return false;
  }
  return true;
}

/// \returns whether everything is as it was.
bool undo_members(const fs::path& folder, const std::string& stem, const SetRecord& record) {
  bool done = true;
  for (std::size_t n = 0; n < record.members.size(); ++n) {
    const SetMember& member = record.members[n];
    const fs::path destination = folder / member.name, old = old_of(folder, stem, n);
    const auto there = about(destination);
    const bool is_new = there && there->st_ino == member.inode && !about(part_of(folder, stem, n));
    if (is_new && about(old)) {
      done = ::rename(old.c_str(), destination.c_str()) == 0 && done;
    } else if (is_new && !member.replaces) {
      done = ::unlink(destination.c_str()) == 0 && done;
    }
  }
  return done;
}

/// Removes every file of the set that still waits or was kept, and the record last.
void remove_remains(const fs::path& folder, const std::string& stem) {
  std::vector<fs::path> remains;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
    if (entry.path().filename().native().starts_with(stem + "-")) remains.push_back(entry.path());
  }
  for (const fs::path& path : remains) ::unlink(path.c_str());
  ::unlink((folder / (stem + std::string(record_ending))).c_str());
}

/// A record that a dead run has left, locked by us; nothing if its run lives, or if it is not ours alone to have
/// written: who may write here and is not us could otherwise have files moved in our name.
struct LeftRecord {
  fs::path folder;
  std::string stem;
  Descriptor file;
  std::optional<SetRecord> record;
};

std::optional<LeftRecord> left_record(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | O_NONBLOCK));
  struct stat found {};
  if (!file.is_open() || ::fstat(file.number(), &found) != 0) return {};
  if (!S_ISREG(found.st_mode) || found.st_uid != ::geteuid() || (found.st_mode & (S_IWGRP | S_IWOTH)) != 0) return {};
  if (::flock(file.number(), LOCK_EX | LOCK_NB) != 0 || !is_still_there(file, path)) return {};
  if (found.st_size < 0 || static_cast<std::size_t>(found.st_size) > most_record_bytes) return {};

  std::string bytes(static_cast<std::size_t>(found.st_size), '\0');
  const ssize_t count = ::pread(file.number(), bytes.data(), bytes.size(), 0);
  if (count < 0) return {};
  bytes.resize(static_cast<std::size_t>(count));
  std::string stem = path.filename().native();
  stem.resize(stem.size() - record_ending.size());
  return LeftRecord{path.parent_path(), std::move(stem), std::move(file), parse_record(bytes)};
}

/// The records of a set's other folders, as far as they are still there.
std::vector<LeftRecord> followers_of(const LeftRecord& leading) {
  std::vector<LeftRecord> followers;
  for (const fs::path& path : leading.record->followers) {
    if (auto follower = left_record(path); follower && follower->record) followers.push_back(std::move(*follower));
  }
  return followers;
}

/// A decided set is finished in all its folders, or, where that fails or has failed, undone in all of them.
void recover_decided(const LeftRecord& leading) {
  std::vector<LeftRecord> shares = followers_of(leading);
  bool done = !leading.record->undone && finish(leading.folder, leading.stem, *leading.record);
  for (const LeftRecord& share : shares) done = done && finish(share.folder, share.stem, *share.record);
  if (!done) {
    bool undone = undo_members(leading.folder, leading.stem, *leading.record);
    for (const LeftRecord& share : shares) undone = undo_members(share.folder, share.stem, *share.record) && undone;
    if (!undone) return;  // it can be tried again
  }
  for (const LeftRecord& share : shares) remove_remains(share.folder, share.stem);
  remove_remains(leading.folder, leading.stem);
}

void recover(const fs::path& path) {
  std::optional<LeftRecord> left = left_record(path);
  if (!left) return;
  if (left->record && left->record->leader.empty()) return recover_decided(*left);

  // Another folder leads. Its record goes last, so one that is gone, or not whole, was never decided.
  if (left->record) {
    if (!about(left->record->leader)) return remove_remains(left->folder, left->stem);
    const fs::path leader = left->record->leader;
    left.reset();  // the leader's recovery locks this one again
    std::optional<LeftRecord> leading = left_record(leader);
    if (leading && leading->record) return recover_decided(*leading);
    if (!leading) return;  // its run lives
    left = left_record(path);
    if (!left) return;
  }
  remove_remains(left->folder, left->stem);
}

void recover_folder(const fs::path& folder) {
  std::vector<fs::path> records;
  std::error_code failed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed)) {
    const std::string name = entry.path().filename().native();
    if (name.starts_with(".pomona-") && name.ends_with(record_ending)) records.push_back(entry.path());
  }
  std::sort(records.begin(), records.end());
  for (const fs::path& record : records) recover(record);
}

}  // namespace

SetFolder::SetFolder(fs::path folder, const fs::path& meant) : folder_(std::move(folder)) {
  recover_folder(folder_);
  for (int n = 0;; ++n) {
    // Another machine may share the folder, so that the process's number alone is not enough.
    stem_ = ".pomona-" + std::to_string(::getpid()) + "-" + std::to_string(n);
    Descriptor file = create_file(record_path(), meant, 0600);
    if (!file.is_open()) continue;
    const bool busy = ::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (busy || !is_still_there(file, record_path())) continue;  // taken for a dead run's
    file_ = std::move(file);
    return;
  }
}

SetFolder::~SetFolder() {
  if (file_.is_open()) remove_remains(folder_, stem_);
}

bool SetFolder::has(const std::string& name) const {
  return std::any_of(record_.members.begin(), record_.members.end(),
                     [&](const SetMember& member) { return member.name == name; });
}

void SetFolder::add(const std::string& name, std::string_view bytes, const SpooledBytes* rest) {
  const fs::path destination = folder_ / name;
  const auto before = about(destination);
  const std::size_t n = record_.members.size();
  Descriptor file = create_file(part_of(folder_, stem_, n), destination, before ? 0600 : 0666);
  if (!file.is_open()) fail_at(ExitStatus::cannot_create, destination, "cannot be created", EEXIST);
  if (before && ::fchmod(file.number(), before->st_mode & 07777) != 0)
    fail_at(ExitStatus::cannot_create, destination, "cannot keep its permissions", errno);
  struct stat made {};
  ::fstat(file.number(), &made);
  record_.members.push_back({name, made.st_ino, before.has_value()});
  write_all(file, bytes, destination);
  if (rest != nullptr) rest->copy_to(file);
  bring_to_disk(file, destination);
}

void SetFolder::keep_old() {
  for (std::size_t n = 0; n < record_.members.size(); ++n) {
    if (!record_.members[n].replaces) continue;
    const fs::path destination = folder_ / record_.members[n].name, old = old_of(folder_, stem_, n);
    if (::link(destination.c_str(), old.c_str()) == 0) continue;

    // Not every file system has second names, and not every file may be given one.
    std::error_code failed;
    fs::copy_file(destination, old, failed);
    if (failed) fail_at(ExitStatus::cannot_create, destination, "cannot be kept aside", failed.value());
  }
}

void SetFolder::write_record(const fs::path& leader, const std::vector<fs::path>& followers) {
  record_.leader = leader;
  record_.followers = followers;
  write_all(file_, record_bytes(record_), record_path());
  if (::fsync(file_.number()) != 0) fail_at(ExitStatus::io_error, record_path(), "cannot be written", errno);
  sync_folder(folder_);
}

void SetFolder::put_into_place() {
  for (std::size_t n = 0; n < record_.members.size(); ++n)
    move_into_place(part_of(folder_, stem_, n), folder_ / record_.members[n].name);
}

void SetFolder::undo(bool recorded) {
  if (recorded && ::write(file_.number(), undo_mark.data(), undo_mark.size()) > 0) ::fsync(file_.number());
  // What cannot be undone now stays for a later run.
  if (!undo_members(folder_, stem_, record_)) file_.close();
}

void SetFolder::settle() {
  sync_folder(folder_);
  remove_remains(folder_, stem_);
  file_.close();
}

}  // namespace pomona
